// Form of vapory: no #version, objects before the camera, one token a line, "( -0.5 )", an empty
// global_settings at the end, a colour without rgb.
#include "colors.inc"
#declare Shine =
finish {
phong
0.6
phong_size
30
}
background {
color
<0.1,0.15,0.3>
}
light_source {
<2,4,-3>
color
<1,1,0.9>
}
sphere {
<( -0.5 ),0.2,0>
0.7
texture {
pigment {
color
<1,0,1>
}
finish {
Shine
}
}
}
box {
<0.1,( -0.6 ),( -0.4 )>
<1.1,0.4,0.5>
texture {
pigment {
checker
color
Yellow
color
<0,0.4,0.6>
scale
0.3
}
}
rotate
<0,30,0>
}
plane {
<0,1,0>
( -0.7 )
pigment {
color
White
}
}
camera {
location
<0.3,1,( -4 )>
look_at
<0.2,0,0>
}
global_settings {
}
