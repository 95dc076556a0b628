// Textures as they were before version 3.0, without blocks for pigment, normal and finish.
#version 1.0
camera { location <0 1 -4> direction <0 0 1.2> up <0 1 0> right <1.33 0 0> look_at <0 0 0> }
object { light_source { <3 5 -4> color red 1 green 1 blue 1 } }
#declare Red = color red 1
#declare Dull = texture { color Red ambient 0.3 diffuse 0.5 }
object {
	sphere { <-1 0 0> 0.9 }
	texture { marble turbulence 0.4 color_map { [0 0.5 color Red color green 1] [0.5 1 color green 1 color blue 1] }
		scale 0.6 bumps 0.4 phong 0.8 phong_size 20 }
	color red 1
}
object { sphere { <1 0 0> 0.9 } texture { Dull bumps 0.5 frequency 2 scale 0.3 } texture { gradient <0 -1 0>
	color_map { [0 1 color red 1 green 1 alpha 0.2 color blue 1 alpha 1] } reflection 0.2 metallic specular 0.6 } }
object { plane { <0 1 0> -1 } texture { checker color red 0.8 green 0.9 blue 1 color red 0.1 scale <1 1 -1> } }
object { box { <-3 -1 -0.5> <-2.2 1 0.5> } texture { wood turbulence 0.1 scale 0.2 rotate <0 90 -10>
	color_map { [0 1 color red 0.9 green 0.6 blue 0.3 color red 0.4 green 0.2] } roughness 0.1 brilliance 2 } }
object { intersection { sphere { <2.5 0 0> 0.6 } plane { <0 0 1> -0.1 inverse } } texture { pigment { hexagon Red color green 1 color blue 1 scale 0.2 } ambient .4 } }
