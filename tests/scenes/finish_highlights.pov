// Phong and specular highlights, metallic and not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
#macro Ball(X, Y) sphere { <X, Y, 0>, 0.48 pigment { rgb <1, 0.7, 0.2> } #end
Ball(-1, 0.5) finish { phong 0.9 } }
Ball(0, 0.5) finish { phong 0.9 phong_size 120 } }
Ball(1, 0.5) finish { phong 0.9 metallic } }
Ball(-1, -0.5) finish { specular 0.8 } }
Ball(0, -0.5) finish { specular 0.8 roughness 0.005 } }
Ball(1, -0.5) finish { specular 0.8 roughness 0.1 metallic 0.7 } }
