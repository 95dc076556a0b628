// A declared texture is complete before the next directive runs.
#version 3.7;
#declare T = texture { pigment { rgb 1 } } #declare U = texture { T finish { ambient 1 } }
sphere { 0, 1 texture { U } }
#debug "passed\n"
