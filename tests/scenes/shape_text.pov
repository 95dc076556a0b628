// Text, with kerning and an offset per letter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
text { ttf "timrom.ttf" "Ave" 0.3, 0 scale 1.3 translate <-1.4, 0.1, 0> rotate y * 20 pigment { rgb <1, 0.6, 0.2> } }
text { ttf "crystal.ttf" "g8%" 0.2, <0.2, 0.05, 0> translate <-1, -0.9, 0> pigment { rgb <0.3, 0.7, 1> } }
