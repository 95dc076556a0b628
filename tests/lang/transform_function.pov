// A function of a transformation gives the transformed point.
#version 3.7;
#declare T = transform { scale <1, 2, 3> rotate <10, 20, 30> translate <4, 5, 6> }
#declare F = function { transform { T } }
#declare G = function { transform { T inverse } }
#declare V = F(1, 2, 3);
#debug concat(vstr(3, V, " ", 0, 9), "|", vstr(3, G(V.x, V.y, V.z), " ", 0, 9), " ",
	str(F(1, 2, 3).y, 0, 9), "\n")
