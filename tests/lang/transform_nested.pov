// transform blocks in one another, identifiers with and without braces.
#version 3.7;
#include "transforms.inc"
#declare A = transform { scale 2 }
#declare B = transform { A translate x }
#declare C = transform { transform B transform { A } rotate 90*z transform { translate y inverse } }
#declare D = transform C
#debug concat(vstr(3, vtransform(<1, 2, 3>, C), " ", 0, 6), "|",
	vstr(3, vtransform(<1, 2, 3>, D), " ", 0, 6), "\n")
