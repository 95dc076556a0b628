// What stands in the wrong place, and what would be right.
#version 3.7;
#declare Coat = texture { pigment { rgb 1 } }
#declare Ball = sphere { 0, 1 }
texture { Coat }
finish { ambient 1 }
}
Coat
sphere { 0, 1 }
object { pigment { rgb 1 } }
sphere { 0, 1 bounded_by { } }
light_source { }
sphere { 0, 1 pigment { facets } }
sphere { 0, 1 texture { phong 1 } }
sphere { 0, 1 texture { color rgb 1 } }
sphere { 0, 1 pigment { Coat } }
object { }
union { Ball Ball }
sphere { 0, 1 interior { ior } }
sphere {
	0, 1
	pigment { rgb 1
	finish { phong 1 }
}
