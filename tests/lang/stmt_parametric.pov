// parametric and its items.
#version 3.7;
#declare P = parametric { function { u } function { v }, function { u*v } <0, 0>, <1, 1>
	contained_by { box { -1, 2 } } accuracy 0.01 max_gradient 2 precompute 5 x, y, z }
#debug "ok\n"
