// Errors and warnings of objects, one after the other.
#version 3.7;
global_settings { assumed_gamma 1 }
text { ttf "no_such_font.ttf" "A" 1, 0 }
union { sphere { 0, 1 } }
merge { }
intersection { sphere { 0, 1 } triangle { 0, x, y } }
difference { box { 0, 1 } union { box { 0, 2 } smooth_triangle { 0, z, x, z, y, z } } }
intersection { sphere { 0, 1 } disc { 0, y, 1 } }
triangle { 0, 0, x }
smooth_triangle { 0, y, 0, y, x, y }
polygon { 3, <0, 0>, <1, 0>, <1, 1> }
polygon { 2, <0, 0>, <1, 0> }
plane { 0, 1 }
cylinder { 0, 0, 1 }
cone { 0, 1, 0, 1 }
sphere { 0, 1 clipped_by { box { -1, 1 pigment { rgb 1 } } } }
sphere { 0, 1 clipped_by { union { triangle { 0, x, y } box { 0, 1 } } } }
sphere { 0, 1 scale <0, 1, 1> }
sphere { 0, 1 matrix <0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0> }
disc { 0, y, 1 inverse }
triangle { 0, x, y inverse }
