// A sky_sphere needs a pigment.
#version 3.7;
sky_sphere { }
