// bicubic_patch and superellipsoid, text.
#version 3.7;
#declare P = bicubic_patch { type 1 flatness 0.01 u_steps 3 v_steps 3
	uv_vectors <0, 0>, <1, 0>, <1, 1>, <0, 1>
	<0, 0, 0>, <1, 0, 0>, <2, 0, 0>, <3, 0, 0>, <0, 1, 0>, <1, 1, 1>, <2, 1, 1>, <3, 1, 0>,
	<0, 2, 0>, <1, 2, 1>, <2, 2, 1>, <3, 2, 0>, <0, 3, 0>, <1, 3, 0>, <2, 3, 0>, <3, 3, 0> }
superellipsoid { <0.5, 0.25> }
text { ttf "crystal.ttf" "Text", 0.5, 0 }
text { ttf "cyrvetic.ttf", "T" 1 0.1*x pigment { rgb 1 } }
#debug "ok\n"
