// The default texture cannot be made of a pattern.
#version 3.7;
#default { texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } } }
