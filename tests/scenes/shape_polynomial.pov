// A surface of the fourth order by its terms.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 0.6 xyz(0, 0, 4): 9, xyz(2, 1, 0): 0.7, xyz(0, 0, 4): 1
	xyz(0, 1, 1): -0.5, xyz(0, 0, 0): -1 pigment { rgb <0.8, 0.5, 0.3> } translate y * 0.4 }
