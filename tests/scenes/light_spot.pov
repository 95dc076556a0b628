// Spotlights: a soft edge, a hard one, a tight one, and a cylinder of light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, -0.6, 0> angle 40 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
light_source { <-2, 3, -1> rgb <1, 0.6, 0.4> spotlight point_at <-1, -1, 0> radius 10 falloff 20 }
light_source { <0.4, 3, -1> rgb <0.4, 1, 0.5> spotlight point_at <0.3, -1, 0.5> radius 8 falloff 8.1 tightness 2 }
light_source { <2, 3, -1> rgb <0.4, 0.5, 1> spotlight point_at <1.3, -1, 0> radius 0 falloff 25 tightness 20 }
sphere { <-1, -0.7, 0>, 0.3 pigment { rgb 1 } }
