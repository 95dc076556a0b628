// A float has the component x.
#version 3.7;
#declare F = 3;
#debug concat(str(F.x, 0, 0), str(F.u, 0, 0), str(F.red, 0, 0), "\n")
