// The components of vectors are read at sum level.
#version 3.7;
#declare A = <1 = 1, 2, 3>;
