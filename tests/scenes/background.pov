// A background colour, also behind something transparent.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
background { rgb <0.2, 0.3, 0.6> }
sphere { 0, 0.8 pigment { rgbt <1, 0.5, 0.3, 0.5> } }
