// Four components where three are wanted are an error.
#version 3.7;
sphere { <1, 2, 3, 4>, 1 }
