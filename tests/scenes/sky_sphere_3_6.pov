// Layers of the sky as before version 3.7.
#version 3.6; global_settings{assumed_gamma 1}
camera{location <0,1,-6> look_at <0,1.6,0> right x*4/3 angle 45}
background{rgb <.1,.2,.4>}
sky_sphere{pigment{gradient y color_map{[0 rgb <.9,.7,.5>][1 rgbt <.1,.2,.8,.5>]}} pigment{bozo color_map{[0 rgbt 1][.5 rgbf <.8,.7,.9,.6>][1 rgb 1]} scale .2} rotate x*20}
sphere{<0,.7,0>,.7 pigment{rgb 0} finish{reflection .9}}
