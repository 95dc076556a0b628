// The angle of a perspective camera is below 180 degrees.
#version 3.7;
camera { location -5*z angle 180 }
sphere { 0, 1 }
