// The '=' of a declaration.
#version 3.7;
#declare A 5;
