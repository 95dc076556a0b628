// The transformations of transforms.inc.
#version 3.7;
#include "transforms.inc"
#macro Show(T) #debug concat(vstr(3, vtransform(<1, 2, 3>, transform { T }), " ", 0, 6), "\n") #end
Show(transform { Shear_Trans(x, <0.5, 1, 0>, z) })
Show(transform { Axis_Rotate_Trans(<1, 1, 0>, 60) })
Show(transform { Axial_Scale_Trans(<1, 1, 0>, 2) })
Show(transform { Rotate_Around_Trans(<0, 30, 0>, <1, 0, 1>) })
Show(transform { Reorient_Trans(x, <1, 1, 1>) })
Show(transform { Point_At_Trans(<1, 2, 0>) })
Show(transform { Matrix_Trans(y, z, x, <1, 1, 1>) })
#debug concat(vstr(3, vinv_transform(<1, 2, 3>, transform { rotate 45*y translate x }),
	" ", 0, 6), "\n")
