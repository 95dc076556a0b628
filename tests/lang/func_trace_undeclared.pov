// The normal of trace goes into a vector that is declared.
#version 3.7;
#declare O = sphere { 0, 1 }
#declare P = trace(O, -5*z, z, Norm);
