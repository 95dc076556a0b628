// vrotate turns about x, then y, then z; vaxis_rotate about any axis.
#version 3.7;
#debug concat(vstr(3, vrotate(<1, 2, 3>, <30, 40, 50>), ",", 0, 9), "\n")
#debug concat(vstr(3, vrotate(x, 90*z), ",", 0, 9), "\n")
#debug concat(vstr(3, vaxis_rotate(<1, 2, 3>, <1, 1, 1>, 120), ",", 0, 9), "\n")
#debug concat(vstr(3, vaxis_rotate(x, 5*y, 30), ",", 0, 9), "\n")
