// Three components where two are wanted are an error.
#version 3.7;
bicubic_patch { type 0 flatness 0.1 u_steps 3 v_steps 3 uv_vectors <0,0,0> <1,0> <1,1> <0,1>
	0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 }
