// Transformations move textures attached before them, not later ones.
#version 3.7;
#declare P = pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } }
#declare F = function { pigment { P translate 0.25*x } }
#declare G = function { pigment { P scale 2 translate 0.5*x } }
#debug concat(str(F(0.5, 0, 0).red, 0, 5), " ", str(G(1, 0, 0).red, 0, 5), "\n")
