// A plane needs a normal.
#version 3.7;
plane { <0, 0, 0>, 1 }
