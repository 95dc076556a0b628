// Dividing by a constant multiplies with its reciprocal, dividing by a variable does not.
#version 3.7;
#declare F = function(x) { x/49 }
#declare G = function(x, y) { x/y }
#debug concat(str((F(49) - 1)*1e18, 0, 3), " ", str((G(49, 49) - 1)*1e18, 0, 3), "\n")
#debug concat(str((F(7) - 7/49)*1e18, 0, 3), "\n")
