// Boxes with corners in any order, turned and sheared.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> rotate <20, 30, 0> translate -x pigment { rgb <1, 0.5, 0.2> } }
box { <0.5, 0.5, 0.5>, <-0.5, -0.5, -0.5>
	matrix <1, 0, 0, 0.5, 1, 0, 0, 0, 1, 1, 0, 0> pigment { rgb <0.3, 0.8, 0.3> } }
