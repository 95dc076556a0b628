// Blobs: the components old and new, texture and transformation of their own.
#version 3.7;
#declare A = blob { threshold 0.5 component 1, 1, 0 component 1 1 x
	sphere { 0, 1, 1 } sphere { y, 1, strength 2 scale 2 pigment { rgb 1 } }
	cylinder { 0, x, 1, 1 } cylinder { 0 x 1 strength 1 texture { pigment { rgb x } } } hierarchy off sturm }
#debug "ok\n"
