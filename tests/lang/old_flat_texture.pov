// Before version 3.0 the items of pigment, normal and finish may stand in the texture itself.
#version 2.0
#declare Red = color red 1
#declare Shiny = finish { phong 1 }
#declare T = texture { Red 0.05 ambient 0.3 }
sphere { <0 0 0> 1
	texture { T color green 1 finish { Shiny } }
	texture { marble turbulence 0.5 bumps 0.4 frequency 3 scale 2 specular 0.5 metallic
		color_map { [0, 1 color Red color blue 1 alpha 1] } }
}
box { <-1, -1, -1>, <1, 1, 1> texture { checker color Red color blue 1 refraction 1 ior 1.5 } }
// from 3.0 on a pattern makes a texture of textures
#version 3.0
plane { y, 0 texture { gradient x texture_map { [0 T] [1 T] } } }
