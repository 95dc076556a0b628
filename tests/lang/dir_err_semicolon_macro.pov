// A semicolon behind a macro call is an error.
#version 3.7;
#macro M() #end
M();
