// The left-over components with scale and translate.
#version 3.7;
#declare V = <1, 2, 3>;
#macro Box(O) #debug concat(vstr(3, max_extent(O) + 0, ",", 0, 3), "\n") #end
#declare O = box { 0, 1 scale V.y } Box(O)
#declare O = box { 0, 1 scale V.y*2 } Box(O)
#declare O = box { 0, 1 scale V.x + 1 } Box(O)
#declare O = box { 0, 1 translate -V.z } Box(O)
#declare O = box { 0, 1 scale 2*V.y } Box(O)
#declare O = box { 0, 1 scale (V.y) } Box(O)
