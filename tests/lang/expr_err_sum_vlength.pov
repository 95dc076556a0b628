// The argument of vlength is read at sum level.
#version 3.7;
#declare A = vlength(1 = 2);
