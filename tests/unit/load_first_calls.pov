// Whose H comes first is found by tracing: that of the sphere, which one of the last blocks shows.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Ridged = function { internal(59) }
camera { location -5*z right x*4/3 }
sphere { <2.4, -1.9, 0>, 0.3 pigment { function { Ridged(x, y, z, 0.3, 2.2, 8, 0.9, 0.9, 2) } } }
sphere { <2.4, -1.9, 9>, 0.1 pigment { function { Ridged(x, y, z, 0.7, 2.2, 8, 0.9, 0.9, 2) } } }
