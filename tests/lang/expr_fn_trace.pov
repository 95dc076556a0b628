// trace gives the first hit and the normal there, zeros on a miss.
#version 3.7;
#declare S = sphere { 0, 1 }
#declare N = <9, 9, 9>;
#debug concat(vstr(3, trace(S, -5*z, z), ",", 0, 6), "\n")
#debug concat(vstr(3, trace(S, <0.6, 0, -5>, 3*z, N), ",", 0, 6), " ", vstr(3, N, ",", 0, 6), "\n")
#debug concat(vstr(3, trace(S, 5*x, z, N), ",", 0, 6), " ", vstr(3, N, ",", 0, 6), "\n")
