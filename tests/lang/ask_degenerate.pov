// Shapes that are nowhere may be asked: no ray meets them.
#macro Ask(O)
	#local N = <9, 9, 9>;
	#local P = trace(O, -5*z, z, N);
	#debug concat(vstr(3, P, " ", 0, 3), " | ", vstr(3, N, " ", 0, 3), "\n")
#end
#declare Point = triangle { 0, 0, 0 }
#declare Line = polygon { 4, <0, 0>, <1, 0>, <2, 0>, <0, 0> }
Ask(Point)
Ask(Line)
sphere { 0, 1 }
