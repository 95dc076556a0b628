#version 3.7;
#declare S = spline { natural_spline }
