#version 3.7;
#declare Radius = 2;
sphere { 0, Raduis }
