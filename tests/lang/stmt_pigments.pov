// Pigments: patterns, lists, maps, warps.
#version 3.7;
#declare A = pigment { checker rgb 1, rgb 0 scale 2 }
#declare A = pigment { brick color rgb 1 color rgb x brick_size <4, 2, 1> mortar 0.1 }
#declare A = pigment { hexagon rgb x rgb y rgb z }
#declare A = pigment { checker pigment { rgb 1 } pigment { A } }
#declare A = pigment { marble turbulence 0.5 octaves 4 omega 0.6 lambda 2.1 color_map {
	[0 rgb 0] [1 rgb 1] } }
#declare A = pigment { wood pigment_map { [0 A] [0.5 rgb x]
	[1 gradient y] } frequency 2 phase 0.3 sine_wave }
#declare A = pigment { average pigment_map { [1 rgb x] [2 rgb y] } }
#declare A = pigment { spiral1 3 }
#declare A = pigment { spiral2 4 poly_wave 2 }
#declare A = pigment { mandel 20 exterior 1, 2 interior 2, 1 }
#declare A = pigment { julia <0.3, 0.5>, 20 }
#declare A = pigment { crackle form <1, 0, 0> metric 1 offset 0.2 solid }
#declare A = pigment { bozo warp { turbulence 0.2 octaves 3 } warp { repeat x offset 0.5*y flip z } quick_color rgb 1 }
#declare A = pigment { bozo warp { black_hole 0, 1 strength 2 falloff 1 inverse } warp { planar y, 0 } }
#declare A = pigment { bozo warp { cylindrical orientation z dist_exp 1 } warp { toroidal major_radius 2 } }
#declare A = pigment { agate agate_turb 0.5 scallop_wave }
#declare A = pigment { quilted control0 0.5 control1 1 }
#declare A = pigment { image_map { png "test.png" once interpolate 2 map_type 0 filter all 0.5 transmit 1, 0.5 } }
#declare A = pigment { function { x*y } color_map { [0 rgb 0] [1 rgb 1] } ramp_wave }
#declare A = pigment { object { sphere { 0, 1 } rgb 1, rgb 0 } }
#debug "ok\n"
