// Normalizing a zero vector gives a zero vector.
#version 3.1;
#debug concat(vstr(3, vnormalize(<0, 0, 0>), " ", 0, 3), "\n")
