// Logic and negation work component by component.
#version 3.7;
#debug concat(vstr(3, (<1, 0, 2> & <1, 1, 0>), ",", 0, 0), " ", vstr(3, (<1, 0, 0> | <0, 0, 5>),
	",", 0, 0),
	" ", vstr(3, !<0, 4, 0>, ",", 0, 0), "\n")
