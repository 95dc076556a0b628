// height_field of a picture and of a function.
#version 3.7;
#declare H = height_field { png "plasma2.png" smooth water_level 0.1 hierarchy on }
#declare I = height_field { function 8, 8 { x*y } scale 2 }
#debug "ok\n"
