// uv_mapping within the pigment of the default texture, on shapes that were moved.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 }
light_source { <-10, 20, -15> rgb 1 }
#default { texture { pigment { uv_mapping checker rgb 1, rgb x scale 0.1 } } }
sphere { 0, 1 rotate <30, 40, 50> translate -1.2*x }
sphere { 0, 1 scale <1, 0.5, 1> rotate 20*z translate 1.2*x }
