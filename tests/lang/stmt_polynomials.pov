// quadric, cubic, quartic, poly and polynomial.
#version 3.7;
quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1 }
poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> sturm }
poly { 2 <1 0 0 0 1 0 0 1 0, -1> }
#declare A = polynomial { 2, xyz(2, 0, 0): 1, xyz(0, 2, 0): 1, xyz(0, 0, 2): 1, xyz(0, 0, 0): -1 }
cubic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, -1> }
quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1.5,
	0, 0, 0, 0, 1, 0, -2.5, 0, 0.5625> sturm on }
#debug "ok\n"
