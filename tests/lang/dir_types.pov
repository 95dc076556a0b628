// An identifier may be given a value of any other type.
#version 3.7;
#declare A = 5; #declare A = <1, 2>; #declare A = "text"; #declare A = rgb 1; #declare A = sphere {
	0, 1 }
#declare A = pigment { rgb 1 } #declare A = array[2] { 1, 2 } #declare A = texture { pigment { rgb
	1 } }
#declare A = transform { scale 2 } #declare A = finish { ambient 1 } #declare A = normal { bumps 1 }
#declare A = interior { ior 1.5 } #declare A = material { texture { pigment { rgb 1 } } } #declare
	A = camera { }
#declare A = color_map { [0 rgb 0] [1 rgb 1] } #declare A = media { } #declare A = density { bozo }
#declare A = light_source { 0, 1 } #declare A = fog { distance 1 } #declare A = spline { 0, x 1, y }
#declare A = 6;
#debug concat(str(A, 0, 0), "\n")
