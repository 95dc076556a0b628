// Tori from several sides, one thick.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
torus { 0.7, 0.2 rotate x * -60 translate -x pigment { rgb <1, 0.6, 0.2> } }
torus { 0.4, 0.35 rotate <-30, 0, 20> translate x pigment { rgb <0.3, 0.7, 1> } }
