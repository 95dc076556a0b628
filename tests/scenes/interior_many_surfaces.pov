// Forty clear discs in a row cost no trace level.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
#declare I=0; #while(I<40) disc{<0,1,-4+I*.1>,z,1.5 pigment{rgbt <.9,.95,1,.97>}} #declare I=I+1; #end
sphere{<0,.7,1>,.7 pigment{rgb <1,.5,.2>}}
