// rgb V.x is grey: a full expression has no left-over components.
#version 3.7;
#declare V = <1, 2, 3>;
#declare C = rgb V.y;
#declare D = rgbt V.y;
#debug concat(vstr(5, C, ",", 0, 0), " ", vstr(5, D, ",", 0, 0), "\n")
