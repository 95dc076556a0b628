// Normals: amounts, maps, patterns of pigments.
#version 3.7;
#declare A = normal { bumps }
#declare A = normal { dents, 0.5 scale 2 }
#declare A = normal { ripples 0.3 frequency 3 }
#declare A = normal { gradient x, 1 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } }
#declare A = normal { checker normal { bumps 1 } normal { dents 1 } }
#declare A = normal { average normal_map { [1 bumps 1] [2 dents 0.5] } }
#declare A = normal { wrinkles 0.5 accuracy 0.01 bump_size 2 no_bump_scale }
#declare A = normal { facets coords 0.5 size 1 }
#declare A = normal { bump_map { png "bumpmap_.png" bump_size 2 interpolate 2 } }
#declare A = normal { pigment_pattern { gradient x } 0.5 }
#debug "ok\n"
