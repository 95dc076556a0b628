// A number that would need more than 254 characters is printed with an exponent.
#version 3.7;
#debug concat(str(1e300, 0, 6), " ", str(-1e300, 0, 2), " ", str(strlen(str(1e200, 0, 2)), 0, 0), "\n")
