// Form of ASE, its other camera: perspective with the focal length as `direction 50*z`.
#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 1 max_trace_level 6}
background {color White}
camera {perspective
  right -8.00*x up 6.00*y
  direction 50.00*z
  location <0,0,50.00> look_at <0,0,0>}
light_source {<2.00, 3.00, 40.00> color White}
#declare glass3 = finish {ambient .3 diffuse .3 specular .25 reflection .45 roughness .004}
#declare intermediate = finish {ambient .05 diffuse .1 specular 1 reflection .1 roughness .001}
sphere {<-1.2, 0.3, 0>, 1.3 texture {pigment {color rgb <0.7, 0.7, 0.2> transmit 0.0} finish {glass3}}}
sphere {<1.1, -0.6, 0.5>, 1.0 texture {pigment {color rgb <0.3, 0.3, 0.9> transmit 0.0} finish {intermediate}}}
