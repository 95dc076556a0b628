// views: D=0 D=1
// What a disc cuts off is what the plane it lies in cuts off: its inside is not bounded by its edge.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 6, -18> look_at <0, 2, 0> right x angle 45 }
light_source { <10, 30, -20> 1 }
#macro Lid(Y, R)
	#if (D) plane { -y, -Y } #else disc { Y*y, -y, R } #end
#end
plane { y, 0 pigment { checker rgb 1 rgb <0.2, 0.4, 0.2> } }
intersection {
	sphere { <0,-5,0>, 10 }
	object { Lid(0, 10.1) }
	translate 0.0002*y
	pigment { rgbf <0.8, 1, 0.95, 0.9> }
	finish { specular 1 roughness 0.001 ambient 0 diffuse 0 reflection 0.1 }
	interior { ior 1.5 }
}
sphere { <-4, 0, -6>, 1.5 clipped_by { object { Lid(1, 20) } } pigment { rgb x } }
difference { box { <3, 0, -7>, <5, 2, -5> } object { Lid(1.2, 20) } pigment { rgb y } }
intersection { sphere { <0, 1, -8>, 0.7 } union { object { Lid(1, 20) } sphere { <0, 0.5, -8.3>, 0.3 } } pigment { rgb z } }
