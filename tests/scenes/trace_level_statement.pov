// The depth of reflection, limited at the top level as old scenes do.
#version 3.7;
global_settings { assumed_gamma 1 adc_bailout 0.02 }
max_trace_level 3
max_intersections 64
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
box { <-2, -1, 1>, <2, 1, 1.1> pigment { rgb 0.05 } finish { reflection 0.9 } }
box { <-2, -1, -6.1>, <2, 3, -6> pigment { rgb 0.05 } finish { reflection 0.9 } }
sphere { <-0.7, 0, 0>, 0.4 pigment { rgb <1, 0.6, 0.2> } }
