// atan2 knows the quadrant.
#version 3.7;
#debug concat(vstr(4, <atan2(1, 1), atan2(1, -1), atan2(-1, -1), atan2(0, -1)>, " ", 0, 9), "\n")
