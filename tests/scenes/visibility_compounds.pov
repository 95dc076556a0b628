// Children of compounds that some rays do not see: hidden from the merge, but inside it for what is around it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at 0 angle 50 }
light_source { <-5, 8, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.4 } finish { reflection 0.3 } }
box { <-5, -1, 3.4>, <5, 4, 3.5> pigment { rgb 0.1 } finish { reflection 0.8 } }
#declare A = sphere { -0.4*x, 0.8 pigment { rgb <1, 0.3, 0.2> } }
#declare B = sphere { 0.4*x, 0.8 pigment { rgb <0.3, 0.3, 1> } }
#declare C = box { <-0.3, -0.9, -0.8>, <0.3, 0.9, 0.8> pigment { rgb <0.2, 1, 0.2> } }
merge { object { A no_image } object { B } object { C no_reflection } translate <-2.6, 0, 1> }
union { object { A no_reflection } object { B no_shadow } split_union off translate <0, 0, 1.5> }
union { object { A no_shadow } object { B } bounded_by { box { -2, 2 } } translate <2.6, 0, 1> }
difference { merge { object { A no_image } object { C } } object { B } translate <-2.4, 0, -2> }
sphere { <0, 0, -2>, 1.3 pigment { rgbt 0.9 } }
merge { union { object { A no_image } object { C } } object { B } translate <0, 0, -2> }
merge {
	object { A no_image pigment { rgbf 0.9 } interior { ior 1.3 } }
	object { B pigment { rgbf 0.8 } interior { ior 1.2 } }
	translate <2.4, 0, -2>
}
