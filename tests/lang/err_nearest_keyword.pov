// In a block the nearest word may be a reserved one.
#version 3.7;
#declare Figment = 1;
sphere { 0, 1 pigmet { rgb 1 } }
