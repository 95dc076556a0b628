// sturm belongs to shapes that solve polynomials.
#version 3.7;
sphere { 0, 1 sturm }
