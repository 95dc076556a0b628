// Ambient, emission, diffuse and brilliance.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
#macro Ball(X, Y) sphere { <X, Y, 0>, 0.48 pigment { rgb <1, 0.7, 0.4> } #end
Ball(-1, 0.5) finish { ambient 0.4 diffuse 0.3 } }
Ball(0, 0.5) finish { ambient 0 emission <0, 0.2, 0.4> diffuse 0.8 } }
Ball(1, 0.5) finish { brilliance 4 } }
Ball(-1, -0.5) finish { brilliance 0.4 diffuse 0.9 ambient 0 } }
Ball(0, -0.5) finish { diffuse 0.5, 0.4 } }
Ball(1, -0.5) finish { ambient rgb <0.5, 0, 0> } }
