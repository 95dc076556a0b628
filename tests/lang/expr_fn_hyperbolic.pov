// Hyperbolic functions and their inverses.
#version 3.7;
#debug concat(vstr(3, <sinh(1), cosh(1), tanh(1)>, " ", 0, 12), "\n")
#debug concat(vstr(3, <asinh(1), acosh(2), atanh(0.5)>, " ", 0, 12), "\n")
#debug concat(str((acosh(0) = 5), 0, 0), str((atanh(2) = 5), 0, 0), " ", str(atanh(1), 0, 0), "\n")
