// max takes floats only.
#version 3.7;
#declare A = max(x, 1);
