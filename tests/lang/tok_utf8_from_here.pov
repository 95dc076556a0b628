// charset holds from its place on.
#version 3.7;
#declare A = "ä";
global_settings { charset utf8 }
#declare B = "ä";
global_settings { charset ascii }
#declare C = "ä";
#debug concat(str(strlen(A), 0, 0), str(strlen(B), 0, 0), str(strlen(C), 0, 0), "\n")
