// Errors of statements, one after the other.
#version 3.7;
#declare A = min_extent(5);
#declare F = 1;
#declare B = dimension_size(F, 1);
sphere { 0, "a" }
text { ttf "timrom.ttf" 5, 1, 0 }
poly { 99, <1, 2> }
sphere { 0, 1 pigment { magnet 3 mandel 5 } }
global_settings { noise_generator 9 }
global_settings { assumed_gamma 0 }
#declare Cam = camera { location 0 }
camera { Cam location 1 }
mesh2 { face_indices { 0 } }
mesh2 { vertex_vectors { 3, 0, x, y } }
mesh2 { vertex_vectors { 3, 0, x } face_indices { 1, <0, 1, 2> } }
#declare C = array[0];
#declare D = array[2] { 1, "a" };
#declare E = array[2][2] { 1, 2 };
#declare G = array[2] { { 1 }, { 2 } };
#declare S = datetime(1e300);
#declare T = transform { scale 2 }
#declare H = function(x) { sum(i, 1, 2, i) + Nothing(x) }
