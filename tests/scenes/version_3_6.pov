// An old scene: no gamma anywhere, old ambient, old noise.
#version 3.6;
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { -x, 0.8 pigment { bozo scale 0.2 } finish { phong 0.5 } }
sphere { x, 0.8 pigment { granite color_map { [0 rgb <0.5, 0.2, 0>] [1 rgb 1] } } finish { reflection 0.3 } }
