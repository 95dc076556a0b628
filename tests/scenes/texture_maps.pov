// Textures chosen by maps, lists, averages and tiles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
#declare A = texture { pigment { rgb <1, .3, .2> } normal { bumps .5 scale .1 } finish { phong .5 } }
#declare B = texture { pigment { rgb <.3, .8, .2> } normal { dents 1 scale .2 } finish { specular .8 metallic reflection .3 } }
sphere { <-1.1, 0, 0>, 1 texture { gradient y texture_map { [.2 A] [.7 bozo texture_map { [.3 B] [.6 A] } scale .3] } scale 1.5 rotate 30 } }
sphere { <1.1, 0, 0>, 1 texture { average texture_map { [1 A] [3 B] } } }
plane { y, -1.01 texture { tiles { texture { A } tile2 texture { B } } scale .7 } }
plane { z, 3 texture { checker texture { A } texture { B } scale .5 } }
