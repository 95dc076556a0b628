// An average of averages has four hundred parts, and all of them count.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -z*2 look_at 0 up y*2 right x*2 }
#declare Inner = texture { average texture_map {
	#for (I, 1, 20) [1 pigment { rgb <I/20, 0.5, 1> } finish { ambient 1 diffuse 0 }] #end
} }
plane { z, 0 texture { average texture_map { #for (I, 1, 20) [1 Inner] #end } } }
