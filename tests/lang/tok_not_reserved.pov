// Words that are no part of the language may be declared.
#version 3.7;
#declare tau = 1; #declare sred = 2; #declare tuple = 3; #declare grey = 4; #declare sqrt2 = 5;
#debug concat(vstr(5, <tau, sred, tuple, grey, sqrt2>, " ", 0, 0), "\n")
