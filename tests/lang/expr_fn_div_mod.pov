// div cuts the real quotient, mod has the sign of its first argument.
#version 3.7;
#debug concat(vstr(4, <div(7.9, 2.1), div(-7, 2), div(7, -2), div(1, 3)>, " ", 0, 0), "\n")
#debug concat(vstr(4, <mod(7.5, 2), mod(7.5, -2), mod(-7.5, 2), mod(1, 0.3)>, " ", 0, 4), "\n")
#debug concat(str(div(1, 0), 0, 0), " ", str((mod(1, 0) = 5), 0, 0), "\n")
