// The default texture for what follows.
#version 3.7;
#default { texture { pigment { rgb 1 } } }
#default { pigment { rgb x } finish { ambient 0.3 } }
sphere { 0, 1 }
#debug "ok\n"
