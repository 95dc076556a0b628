// Shadows through things that filter, transmit, and are layered.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
box { <-1.6, -0.2, -0.4>, <-0.7, -0.1, 0.6> pigment { rgbf <1, 0.2, 0.2, 0.8> } }
box { <-0.4, -0.2, -0.4>, <0.4, -0.1, 0.6> pigment { rgbt <0.2, 0.2, 1, 0.6> } }
box { <0.7, -0.2, -0.4>, <1.6, -0.1, 0.6>
	texture { pigment { rgbf <0.9, 0.9, 0.2, 0.9> } } texture { pigment { checker rgbt 1, rgbt <0, 0, 0, 0.2> scale 0.3 } } }
