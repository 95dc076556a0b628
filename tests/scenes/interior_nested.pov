// Interiors within and across each other.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
global_settings{max_trace_level 12}
sphere{<0,1,0>,1 pigment{rgbf <.9,.95,.9,.9>} interior{ior 1.5} finish{reflection{.02,1 fresnel} conserve_energy}}
sphere{<0,1,0>,.7 pigment{rgbf <.9,.95,1,.9>} interior{ior 1.2} finish{reflection{.02,1 fresnel} conserve_energy}}
sphere{<.9,1,-.3>,.5 pigment{rgbf <.9,.7,1,.9>} interior{ior 1.33 fade_distance .5 fade_power 1000 fade_color rgb<.5,.8,.4>} finish{reflection{.02,1 fresnel} conserve_energy}}
