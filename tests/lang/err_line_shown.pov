// The line is shown beyond the place where the text goes wrong.
#version 3.7;
sphere { 0, 3..4 pigment { rgb 1 } } // the end
