#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 pigment { pavement number_of_sides 5 } }
sphere { 0, 1 pigment { pavement number_of_sides 6 number_of_tiles 6 } }
sphere { 0, 1 pigment { pavement number_of_sides 3 number_of_tiles 4 pattern 4 } }
sphere { 0, 1 pigment { pavement number_of_tiles 1e30 } }
