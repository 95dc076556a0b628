// After rgb a full expression is read: comparisons need no parentheses.
#version 3.7;
#declare C = rgb 2 > 1;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgb <1, 2, 3> * 0.5 + 1;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare V = <0.25, 0.5, 0.75>;
#declare C = rgb V.y;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
