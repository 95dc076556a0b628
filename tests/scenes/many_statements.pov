// A scene whose statements are lowered while it is read on: what stands before and behind many of
// them belongs together all the same.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -14> look_at 0 angle 40 }
light_source { <-10, 20, -15> rgb 1 }
#declare Spotted = texture { pigment { bozo color_map { [0 rgb x] [1 rgb z] } scale 0.3 } }
#declare Pebble = sphere { 0, 0.09 pigment { granite color_map { [0 rgb 0.2] [1 rgb <1, 0.9, 0.6>] } } }
sphere { <-3.5, 2, 0>, 1.4 texture { Spotted } }
sphere { <0, 2, 0>, 1.4 pigment { rgb 1 } normal { ripples 0.6 scale 0.4 } }
#declare I = 0;
#while (I < 3000)
	sphere {
		<mod(I, 75)/7.5 - 5, -int(I/75)/10 + 0.2, 0>, 0.045
		pigment { rgb <mod(I, 7)/7, mod(I, 11)/11, 0.4> }
		finish { phong 0.3 + mod(I, 3)/10 }
	}
	#if (mod(I, 100) = 0)
		#default { finish { ambient 0.05 + I/30000 } }
		#declare Spotted = texture { Spotted scale 1.01 }
		object { Pebble translate <I/300 - 5, 0.6, -1> }
	#end
	#declare I = I + 1;
#end
sphere { <3.5, 2, 0>, 1.4 texture { Spotted } }
global_settings { noise_generator 3 number_of_waves 3 }
