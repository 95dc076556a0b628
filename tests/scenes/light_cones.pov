// Spotlights with soft and hard edges, a cylinder light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
light_source{<-3,5,-4> rgb 1 spotlight point_at 0 radius 6 falloff 12 tightness 4}
light_source{<3,5,-4> rgb <1,.8,.3> cylinder point_at <1,0,0> radius .5 falloff 1.2 tightness .3}
light_source{<0,5,-2> rgb <.1,.3,.9> spotlight point_at <0,1,3> radius 15 falloff 8}
sphere{<0,.7,0>,.7 pigment{rgb 1} finish{phong 1}}
