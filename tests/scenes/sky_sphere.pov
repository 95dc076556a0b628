// A sky of two pigments, seen directly and in a mirror.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sky_sphere {
	pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.7>] [0.4 rgb <0.2, 0.4, 0.9>] } scale 2 translate -1 }
	pigment { bozo turbulence 0.5 scale <0.5, 0.2, 0.5> color_map { [0.5 rgbt 1] [0.8 rgbt <1, 1, 1, 0.1>] } }
	rotate z * 10
}
sphere { 0, 0.8 pigment { rgb 0 } finish { reflection 0.9 ambient 0 diffuse 0 } }
