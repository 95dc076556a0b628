// Strings are not added.
#version 3.7;
#declare S = "a" + "b";
