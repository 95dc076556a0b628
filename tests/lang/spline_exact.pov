// The last bits of splines.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare L = spline { linear_spline -1, <0, 0, 1> 0, <1, 0.3, 0> 0.7, <2, -1, 5> 2, <3, 4, 1> }
#declare Q = spline { L quadratic_spline }
#declare C = spline { L cubic_spline }
#declare N = spline { L natural_spline }
#declare Stream = seed(3);
#for (I, 1, 20)
	#declare T = 4*rand(Stream) - 1.5;
	#debug concat(vstr(3, L(T), " ", 0, 16), "\n", vstr(3, Q(T), " ", 0, 16), "\n")
	#debug concat(vstr(3, C(T), " ", 0, 12), "\n", vstr(3, N(T), " ", 0, 16), "\n")
#end
camera { location -z look_at 0 }
