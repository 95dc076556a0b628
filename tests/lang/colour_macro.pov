// A directive or a macro may stand between rgb and its vector.
#version 3.7;
#macro Half() 0.5 #end
#declare C = rgb #if (1) <Half(), 1, #else <0, 0, #end Half()*0.5>;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
