// Too many arguments.
#version 3.7;
#declare A = atan2(1, 2, 3);
