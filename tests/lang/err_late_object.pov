// Objects behind what changes the objects before them, and behind the name of an object.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = sphere { 0, 1 }
union { sphere { 0, 1 } box { -1, 1 } pigment { rgb 1 } sphere { x, 1 } }
difference { box { -1, 1 } rotate x S }
intersection { box { -1, 1 } rotate x light_source { 0, 1 } }
union { S box { -1, 1 } }
merge { S S }
mesh { triangle { 0, x, y } pigment { rgb 1 } triangle { 0, x, z } }
blob { sphere { 0, 1, 1 } pigment { rgb 1 } sphere { x, 1, 1 } }
sphere { 0, 1 clipped_by { plane { y, 0 } rotate x plane { x, 0 } } }
object { S sphere { x, 1 } }
union {
	sphere { 0, 1 }
	pigment { rgb 1 }
sphere { y, 1 }
