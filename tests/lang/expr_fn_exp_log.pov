// exp, ln, log, sqrt, pow.
#version 3.7;
#debug concat(vstr(4, <exp(1), ln(10), log(1000), sqrt(2)>, " ", 0, 12), "\n")
#debug concat(vstr(4, <pow(2, 10), pow(2, -1), pow(-2, 3), pow(2, 0.5)>, " ", 0, 12), "\n")
#debug concat(str(pow(0, -1), 0, 0), " ", str((pow(-2, 0.5) = 7), 0, 0), " ", str(pow(0, 1), 0, 0),
	"\n")
