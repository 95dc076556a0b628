// Trigonometric functions in radians; degrees and radians.
#version 3.7;
#debug concat(vstr(3, <sin(1), cos(1), tan(1)>, " ", 0, 12), "\n")
#debug concat(vstr(3, <asin(0.5), acos(0.5), atan(0.5)>, " ", 0, 12), "\n")
#debug concat(vstr(3, <degrees(1), radians(180), pi>, " ", 0, 12), "\n")
