// A sphere, and one scaled to an ellipsoid and turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { <-1, 0, 0>, 0.8 pigment { rgb <1, 0.4, 0.2> } }
sphere { 0, 1 scale <0.4, 1, 0.6> rotate z * 30 translate x pigment { rgb <0.2, 0.6, 1> } }
