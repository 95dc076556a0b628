// In #declare a selected component is a float.
#version 3.7;
#declare V = <1, 2, 3>;
#declare A = V.y;
#declare B = V.y + x;
#debug concat(str(vlength(A), 0, 6), " ", vstr(3, B, ",", 0, 0), "\n")
