// No comma stands behind the type.
#version 3.7;
#declare S = spline { natural_spline, 0, x, 1, y }
