// A union that a loop makes of itself and one object more; each state but the last is used once.
#version 3.7;
#declare U = union { sphere { 0, 1 } }
#declare I = 1;
#while (I <= 500)
	#declare U = union { object { U } sphere { I*x, 1 } translate y }
	#declare I = I + 1;
#end
#debug concat(vstr(3, max_extent(U), " ", 0, 2), "\n")
#declare V = union { object { U } object { U translate -500*x } }
#debug concat(vstr(3, min_extent(V), " ", 0, 2), "\n")
