// Layers: a transmitting one and a filtering one above an opaque one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { 0, 1
	texture { pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 } }
	texture { pigment { gradient y scale 0.4 color_map { [0.4 rgbt <1, 1, 1, 1>] [0.5 rgbt <0, 0, 1, 0.2>] } } }
	texture { pigment { checker rgbf 1, rgbf <1, 0.9, 0, 0.6> scale 0.5 } finish { ambient 0 } }
}
