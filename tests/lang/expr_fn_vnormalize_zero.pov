// vnormalize of a zero vector is the zero vector.
#version 3.7;
#debug concat(vstr(3, vnormalize(0), ",", 0, 4), "\n")
