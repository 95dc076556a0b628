// A matrix that flattens space cannot be inverted.
#version 3.7;
#declare T = transform { matrix <1, 1, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0> }
