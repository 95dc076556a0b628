// inverse inverts the whole block, once, wherever it stands and however often.
#version 3.7;
#include "transforms.inc"
#declare T = transform { inverse translate x scale 2 }
#declare U = transform { translate x inverse scale 2 inverse }
#debug concat(vstr(3, vtransform(<4, 4, 4>, T), " ", 0, 6), "|",
	vstr(3, vtransform(<4, 4, 4>, U), " ", 0, 6), "\n")
#debug concat(vstr(3, vinv_transform(<4, 4, 4>, T), " ", 0, 6), "\n")
