// Gradients along an axis and askew; frequency, phase and a sine wave.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
box { <-1.8, 0.1, 0>, <-0.1, 1, 1> pigment { gradient x color_map { [0 rgb 0] [0.3 rgb <1, 0, 0>] [0.3 rgb <0, 0.5, 1>] [1 rgb 1] } } }
box { <0.1, 0.1, 0>, <1.8, 1, 1> pigment { gradient <1, 1, 0> scale 0.5 frequency 2 phase 0.25 } }
box { <-1.8, -1, 0>, <-0.1, -0.1, 1> pigment { gradient y sine_wave scale 0.4 color_map { [0 rgb 0] [1 rgb <1, 1, 0>] } } }
box { <0.1, -1, 0>, <1.8, -0.1, 1> pigment { gradient x triangle_wave scale 0.4 } }
