// The last bits of vrotate: it goes through a matrix, as rotate does.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Stream = seed(3);
#for (I, 1, 40)
	#declare V = 20*<rand(Stream) - 0.5, rand(Stream) - 0.5, rand(Stream) - 0.5>;
	#declare A = 15*<int(24*rand(Stream)), int(24*rand(Stream)), int(24*rand(Stream))>;
	#debug concat(vstr(3, vrotate(V, A), " ", 0, 16), "\n")
#end
camera { location -z look_at 0 }
