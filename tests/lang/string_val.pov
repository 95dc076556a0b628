// val reads as much of a number as there is, in all forms that the C library knows.
#version 3.7;
#debug concat(str(val("  12.5abc"), 0, 3), " ", str(val("-.5e1"), 0, 3), " ", str(val("nothing"), 0, 3), "\n")
#debug concat(str(val("0x1F"), 0, 1), " ", str(val("inf"), 0, 1), "\n")
#debug concat(str(val("+7"), 0, 1), " ", str(val(""), 0, 1), "\n")
