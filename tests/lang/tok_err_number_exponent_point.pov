// A second decimal point behind an exponent is an error.
#version 3.7;
#declare A = 1e.5;
