// Superellipsoids from nearly a box, whose faces lie on the faces of its bounds, to a pinched star.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 45 }
light_source { <-5, 3, -6> rgb 1 }
background { rgb <0.1, 0.2, 0.4> }

#macro Show(E, N, X, Y)
	superellipsoid {
		<E, N>
		pigment { rgb <1, 0.8, 0.5> }
		rotate <20, 30, 0>
		scale 0.8
		translate <X, Y, 0>
	}
#end

Show(0.08, 0.008, -2.2, 1.4)
Show(0.008, 0.08, 0, 1.4)
Show(1, 0.01, 2.2, 1.4)
Show(0.4, 0.6, -2.2, -1.4)
Show(3, 0.02, 0, -1.4)
Show(2.5, 1.5, 2.2, -1.4)
