// There were no macros before 3.1.
#version 3.0;
#macro M() 1 #end
