// The forms of numbers.
#version 3.7;
#debug concat(vstr(5, <1., .5, 007, 1e2, 1.5E-1>, " ", 0, 4), "\n")
#debug concat(vstr(5, <1e, 1e+, 2.e1, .25e+2, 12345678901>, " ", 0, 4), "\n")
#debug concat(vstr(3, <0.1, 1e-7, 123456789.125>, " ", 0, 17), "\n")
