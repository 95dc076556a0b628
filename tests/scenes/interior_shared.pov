// Children without an interior of their own share one: `hollow` and the finish of the last child hold for all.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z right 8*x up 6*y look_at 0 }
background { rgb <0, 0, 1> }
fog { distance 8 rgb <0, 1, 0> }
#declare T = texture { pigment { rgbt 1 } finish { diffuse 0 } }
#declare A = sphere { -0.9*x, 0.8 }
#declare B = sphere { 0.9*x, 0.8 }
union { object { A hollow } object { B } texture { T } interior { ior 1.2 } translate <-2, 2, 0> }
union { object { B } object { A hollow } texture { T } translate <2, 2, 0> }
union {
	object { A texture { T finish { ior 1.3 } } }
	object { B texture { T finish { ior 1.5 } } }
	interior { ior 1.2 }
	translate -2*x
}
union { object { A hollow texture { T } } sphere { 0, 0.2 pigment { rgb 1 } } translate 2*x }
difference { object { A scale <2, 1, 1> } object { B hollow } texture { T } translate <-2, -2, 0> }
merge { object { A hollow } object { B scale 1.3 } texture { T } interior { ior 1.2 } translate <2, -2, 0> }
plane {
	-z, -10 hollow
	pigment { radial frequency 24 rotate 90*x color_map { [0 rgb <1, 0, 0>][1 rgb <1, 0.5, 1>] } }
	finish { ambient 1 diffuse 0 }
}
