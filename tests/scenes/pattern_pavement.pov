// Floors of triangles, squares and hexagons, with all ways around corners.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 8, -0.01> look_at 0 angle 60 }
light_source { <-4, 16, -5> rgb 1 }
#macro Floor(X, Z, Sides, Tiles, Pattern, I)
	box { <-1.2, -0.1, -0.9>, <1.2, 0, 0.9>
		pigment { pavement number_of_sides Sides number_of_tiles Tiles pattern Pattern
			exterior I interior I form I color_map { [0 rgb <1, 0.9, 0.6>][1 rgb <0.3, 0.1, 0>] } scale 0.25 }
		translate <X, 0, Z> }
#end
Floor(-2.5, 2, 3, 5, 4, 0) Floor(0, 2, 3, 6, 12, 1) Floor(2.5, 2, 3, 4, 3, 2)
Floor(-2.5, 0, 4, 6, 35, 0) Floor(0, 0, 4, 5, 9, 1) Floor(2.5, 0, 4, 4, 5, 3)
Floor(-2.5, -2, 6, 5, 22, 0) Floor(0, -2, 6, 4, 7, 1)
box { <-1.2, -0.1, -0.9>, <1.2, 0, 0.9> pigment { rgb 0.8 } normal { pavement 0.4 scale 0.3 } translate <2.5, 0, -2> }
