// Checkers in space: two and default colours, turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { -x, 0.8 pigment { checker rgb <1, 0.9, 0.6>, rgb <0.6, 0.2, 0.1> scale 0.4 rotate <20, 30, 40> } }
box { <0.2, -0.7, -0.5>, <1.6, 0.7, 0.5> pigment { checker scale 0.35 translate 0.01 } }
