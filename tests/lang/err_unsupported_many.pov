// What is not supported yet is named once, with its first place and the number of places: a loop, a macro and
// a scene of a thousand objects do not bury what else is wrong.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Tile(X) sphere { X, 1 pigment { image_map { png "x.png" } } } #end
#for (I, 1, 40) Tile(I*x) sphere { 0, I pigment { image_pattern { png "x.png" } } } #end
sphere { 0, 1 pigment { image_map { png "y.png" } } }
triangle { 0, x, y pigment { image_map { png "y.png" } } }
sphere { 0, 1 finish { subsurface { translucency 1 } } }
sphere { 0, 1 interior_texture { pigment { rgb 1 } } }
