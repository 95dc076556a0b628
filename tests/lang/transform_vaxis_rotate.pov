// vaxis_rotate turns about any axis, which need not have length 1.
#version 3.7;
#debug concat(vstr(3, vaxis_rotate(<1, 2, 3>, <1, 1, 0>, 60), " ", 0, 9), "\n")
#debug concat(vstr(3, vaxis_rotate(x, 5*z, 90), " ", 0, 9), "\n")
#debug concat(vstr(3, vaxis_rotate(<3, 1, 2>, -y, 30), " ", 0, 9), "\n")
