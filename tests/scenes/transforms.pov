// The order of transformations counts; a declared transform; a negative scale.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
#declare Turn = transform { rotate z * 30 translate 0.2 * y }
box { -0.3, 0.3 translate x rotate z * 45 pigment { rgb <1, 0.5, 0.3> } }
box { -0.3, 0.3 rotate z * 45 translate x pigment { rgb <0.3, 0.7, 1> } }
cone { 0, 0.3, 0.8 * y, 0 transform { Turn scale <-1, 1, 1> } translate -x pigment { rgb <0.5, 0.9, 0.3> } }
sphere { 0, 0.4 pigment { gradient y color_map { [0.5 rgb 1] [0.5 rgb x] } scale 0.3 } transform { Turn inverse } translate <-0.4, -0.5, -0.5> }
