// #default holds for what is made afterwards.
#version 3.7;
#default { pigment { rgb 1 } finish { ambient 1 } }
sphere { 0, 1 }
#default { texture { pigment { rgb x } } }
#default { normal { bumps 0.5 } camera { location -5*z } radiosity { importance 0.5 } }
#debug "passed\n"
