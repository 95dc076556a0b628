// Nor layered, if declared so.
#version 3.7;
#declare T = texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } }
#default { texture { T } }
