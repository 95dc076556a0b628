// Layers with the opacity rule of version 3.6.
#version 3.6; global_settings{assumed_gamma 1}
camera{location <0,2,-6> look_at <0,.6,0> right x*4/3 angle 45}
light_source{<3,5,-4> rgb <1,.9,.8>} plane{y,0 pigment{checker rgb .9 rgb <.3,.2,.1>}}
background{rgb <.1,.2,.4>}
sphere{<-1,.7,0>,.7 texture{pigment{rgb <.8,.3,.2>} finish{reflection .2}} texture{pigment{checker rgbt 1 rgbf <.3,.9,.3,.6> scale .3} finish{phong .7 reflection .3}}}
sphere{<1,.7,0>,.7 texture{pigment{rgbt <.8,.3,.2,.4>}} texture{pigment{rgbf <.3,.9,.3,.6>} finish{phong .7}} texture{pigment{bozo color_map{[0 rgbt 1][1 rgb 1]} scale .2}}}
