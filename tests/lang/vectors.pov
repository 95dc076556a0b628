// Vectors: promotion of floats, components, products, rotation.
#version 3.7;
#declare V = <1, 2, 3>;
#declare W = V + 1;
#debug concat(vstr(3, W, ",", 0, 2), "\n")
#debug concat(vstr(3, V * <2, 0.5, 1>, ",", 0, 2), "\n")
#debug concat(str(vdot(V, W), 0, 2), " ", str(vlength(V), 0, 5), "\n")
#debug concat(vstr(3, vcross(x, y), ",", 0, 1), " ", str(V.y, 0, 1), "\n")
#debug concat(vstr(3, vrotate(x, <0, 90, 0>), ",", 0, 4), "\n")
#declare V = 2 * x + 3 * z;
#debug concat(vstr(3, V, ",", 0, 1), "\n")
