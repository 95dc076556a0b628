// Colours, vectors and objects as elements stand wherever an identifier may.
#version 3.7;
#declare C = array[2] { rgb x, rgbt <0, 1, 0, 0.5> }
#declare V = array[2] { <1, 2, 3>, y }
#declare O = array[1] { sphere { V[0], 1 } }
#declare P = array[1] { pigment { C[1] } }
#declare T = array[1] { texture { pigment { P[0] } } }
#declare F = array[1] { function { x*2 } }
#declare G = function { pigment { P[0] } }
object { O[0] texture { T[0] } }
O[0]
#debug concat(vstr(5, G(0, 0, 0), ",", 0, 1), " ", str(F[0](3, 0, 0), 0, 1), "\n")
#debug concat(vstr(3, max_extent(O[0]), ",", 0, 1), "\n")
