// A default texture cannot be layered.
#version 3.7;
#default { texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } } sphere { 0, 1 } }
