// A division by zero is warned about.
#version 3.7;
#declare A = 1/0;
#error "end of the case"
