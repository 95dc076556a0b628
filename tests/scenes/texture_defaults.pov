// A texture starts as a copy of the #default in force.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { bozo scale .3 } }
#default { finish { ambient .3 phong 1 } normal { bumps 1 scale .2 } }
sphere { <-1.1, 0, 0>, 1 }
#declare Plain = pigment { rgb 1 scale .2 }
sphere { <1.1, 0, 0>, 1 pigment { Plain checker } }
#default { texture { pigment { rgb <1, .5, .3> } finish { diffuse .9 } } }
plane { y, -1.01 texture { normal { dents 1 scale .2 } } }
