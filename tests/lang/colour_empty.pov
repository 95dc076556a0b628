// The word color alone is black; a comma may follow the last argument of vturbulence; linking to an empty list does nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare C = color;
#debug concat(vstr(5, C, ",", 0, 1), "\n")
#declare V = vturbulence(2, 0.5, 6, <1.5, 2.5, 3.5>,);
#debug concat(vstr(3, V, ",", 0, 6), "\n")
background { color }
light_source { 0, color }
sphere { 0, 1 pigment { color } clipped_by { bounded_by } bounded_by { sphere { 0, 2 } } }
sphere { 0, 1 pigment { gradient x colour_map { [0 color] [1 color rgb 1] } } finish { ambient color } }
