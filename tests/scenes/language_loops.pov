// A macro, a loop and an array make a ring of balls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
#declare Colours = array[3] { rgb <1, 0.5, 0.2>, rgb <0.3, 0.7, 1>, rgb <0.6, 0.9, 0.3> }
#macro Bead(Angle, Colour) sphere { <cos(Angle), sin(Angle), 0>, 0.2 pigment { Colour } } #end
#local I = 0;
#while (I < 12)
	Bead(2 * pi * I / 12, Colours[mod(I, 3)])
	#local I = I + 1;
#end
