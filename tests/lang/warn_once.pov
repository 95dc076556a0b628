// A warning is shown once for its place, however often a loop or a macro comes by; what the scene
// itself says is shown each time.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Ball(R) sphere { 0, R scale <1, 0, 1> } #end
#for (I, 1, 3)
	#declare A = I / 0;
	Ball(I)
	#warning "turn"
#end
Ball(7)
