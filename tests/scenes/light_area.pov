// Area lights: spotlight with area_illumination, circular and oriented with adaptive.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
light_source{<-3,5,-4> rgb 1 spotlight point_at 0 radius 6 falloff 12 area_light x*1.5,z*2,6,9 adaptive 1 area_illumination}
light_source{<3,5,-4> rgb <.5,.4,.3> area_light x*1.5,y*1.5,9,9 adaptive 2 circular orient fade_distance 5 fade_power 2}
sphere{<0,.7,0>,.7 pigment{rgb 1} finish{phong 1}} torus{.5,.1 pigment{rgbt <1,.4,.3,.5>} translate <1.5,.5,-.5>}
