#version 3.7;
#declare A = mod(7 3) + select(1 2, 3);
#declare B = max(1, 2 3);
