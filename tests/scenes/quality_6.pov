// switches: +W80 +H60 -A +Q6
// Transparency, but no reflection, bumps or fog.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
fog{distance 8 color rgb <.6,.6,.7>}
sphere{<-1,.7,0>,.7 pigment{rgb <.8,.3,.2> quick_color rgb <1,1,0>} normal{bumps 1 scale .1}} sphere{<1,.7,0>,.7 pigment{rgbt <.8,.3,.2,.5>} interior{ior 1.4} finish{reflection .4}}
