// A 2-vector has no component z.
#version 3.7;
#declare A = <1, 2>.z;
