// A float has no component y.
#version 3.7;
#declare F = 3;
#declare A = F.y;
