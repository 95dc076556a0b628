// A seed for the fuzzer: what a text may ask of the renderer, without includes.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare O = intersection { sphere { 0, 1 } box { -.8, .9 rotate 20*y } }
#declare N = <0, 0, 0>;
#declare P = trace(O, <0, .1, -5>, z, N);
#declare Low = min_extent(O);
#declare F = function { pattern { bozo warp { turbulence .3 } } }
#declare G = function(x, y, z) { F(x, y, z) + sqrt(x*x + y*y) - max(z, .5) }
#declare Pigment = function { pigment { marble color_map { [0 rgb 0] [1 rgb <1, .5, .2>] } } }
#declare S = spline { natural_spline 0, <0, 0, 0>, 1, <1, 2, 3>, 2, <0, 1, 0> }
#declare Ridge = function { internal(59) }
#debug concat(vstr(3, P + N + Low + S(.5), " ", 0, 3), str(inside(O, P), 0, 0), str(G(1, 2, 3), 0, 3))
#debug str(Pigment(1, 2, 3).red + Ridge(1, 2, 3, .5, 2, 4, .5, 2, 2), 0, 3)
camera { location <0, 1, -4> look_at 0 }
light_source { <4, 5, -6>, 1 }
object { O pigment { function { G(x, y, z) } } translate S(.3) }
