// How many lights of an area_light are asked, and what each weighs, shows in half shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -11> look_at <0, -0.5, 0> }
#macro Stand(X, Z, U, V, Adaptive, Round)
	light_group {
		light_source {
			<X + 1, 5, Z - 1>, 1
			area_light 2*x, 2*z, U, V
			#if (Adaptive >= 0) adaptive Adaptive #end
			#if (Round) circular orient #end
		}
		box { <X - 1.9, -1, Z - 1.4>, <X + 1.9, -0.9, Z + 1.4> pigment { rgb 1 } }
		sphere { <X, 0.3, Z>, 0.5 pigment { rgb 1 } }
		global_lights off
	}
#end
Stand(-4, 3, 9, 9, 0, 0)
Stand(0, 3, 9, 9, 1, 0)
Stand(4, 3, 8, 8, 1, 0)
Stand(-4, -1, 3, 1, -1, 0)
Stand(0, -1, 4, 4, -1, 0)
Stand(4, -1, 5, 5, 1, 1)
Stand(-2, -4.5, 17, 17, 2, 0)
Stand(2, -4.5, 5, 5, 0, 1)
