// Parallel and shadowless lights, alone and as spotlights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
light_source{<-3,5,-4> rgb .4 spotlight point_at 0 radius 6 falloff 12 shadowless}
light_source{<0,3,-2> rgb .5 parallel point_at <1,0,1> fade_distance 2 fade_power 1.5}
light_source{<1,2,-2> rgb .3 shadowless}
light_source{<-1,4,-2> rgb .3 shadowless spotlight point_at <1,0,1>}
light_source{<-1,4,-2> rgb .3 spotlight parallel point_at <1,0,1>}
sphere{<0,.7,0>,.7 pigment{rgb 1} finish{phong 1}}
