// inside wants an object identifier.
#version 3.7;
#declare A = inside(sphere { 0, 1 }, 0);
