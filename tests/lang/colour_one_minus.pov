// 1 - C makes a transparent colour: the float goes to all five components.
#version 3.7;
#declare G = rgb <0.25, 0.5, 0.75>;
#declare C = rgb 1 - G;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare D = 1 - G;
#debug concat(vstr(5, D, " ", 0, 4), "\n")
