// No lamp, and nothing that needs one: no warning.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }
sphere { 0, 1 pigment { rgb 1 } finish { emission 0.5 } }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection 1 } }
sphere { 0, 1 pigment { rgbt 1 } finish { ambient 0 } interior { ior 1.5 } }
sphere { 0, 1 pigment { rgb 0 } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0.3 diffuse 0.7 } }
#declare Unused = box { 0, 1 pigment { rgb 1 } }
