// The pigments of an object pattern are its list, the same words in an object its modifiers.
#version 3.7;
#declare P = pigment { object { sphere { 0, 1 } pigment { rgb 1 }, pigment { rgb 0 } } }
#declare T = texture {
	object {
		union { sphere { 0, 1 translate x } box { -1, 1 pigment { rgb 1 } } scale 2 }
		texture { pigment { rgb 1 } }, texture { pigment { rgb 0 } finish { phong 1 } }
	}
}
union {
	object { sphere { 0, 1 } pigment { P } }
	object { box { 0, 1 } texture { T } translate y }
}
