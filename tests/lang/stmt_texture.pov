// Textures: identifiers, layers, maps, lists.
#version 3.7;
#declare P = pigment { rgbt 0.5 }
#declare N = normal { bumps 0.3 }
#declare F = finish { phong 1 }
#declare T = texture { P N F scale 2 }
#declare L = texture { pigment { rgb 1 } } texture { pigment { rgbt 0.5 } }
sphere { 0, 1 texture { T finish { ambient 1 } no_bump_scale } texture { P } }
sphere { 0, 1 texture { gradient x texture_map { [0 T] [1 pigment { rgb 1 }] } turbulence 0.2 } }
sphere { 0, 1 texture { checker texture { T }, texture { P } scale 2 } }
sphere { 0, 1 texture { L rotate x } }
sphere { 0, 1 texture { } }
#debug "ok\n"
