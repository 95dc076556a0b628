// A word of another letter case is likelier than an include file that declares it, but for colours.
#version 3.7;
#declare A = 1;
Sphere { 0, 1 }
sphere { a, 1 }
sphere { 0, 1 pigment { color Red } }
