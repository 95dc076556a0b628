// switches: +W5 +H45 -A
// Row 13 looks along the exact horizon, which rounding puts below it.
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,2,-6> look_at <0,.8,0> right x up y }
sky_sphere { pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } }
