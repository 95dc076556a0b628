// Errors of statements that the parser finds, one after the other.
#version 3.7;
sphere { 0, 1 pigment { srgb 1 } }
global_settings { noise_generator 9 }
sphere { 0, 1 pigment { granite warp { } } }
sphere { 0, 1 sturm }
sphere { 0, 1 hierarchy }
sphere { 0, 1 cutaway_textures }
sphere { 0, 1 pigment { magnet 9 mandel 5 } }
mesh2 { vertex_vectors { 3, 0, x, y } }
isosurface { contained_by { box { -1, 1 } } }
isosurface { function { x } contained_by { plane { y, 1 } } }
rainbow { angle 40 width 5 distance 1 }
sphere { 0, 1 split_union on }
torus { 1 }
light_source { 0, 1 radius 5 }
poly { 1, <1, 1, 1, 1> }
