// A comma before an item is not one of a vector without brackets.
#version 3.7;
sphere { 0, 1 finish { ambient 0.1, diffuse 0.9 } }
camera { location <0,0,-3>, look_at 0 }
box { 0, 1, pigment { rgb 1 } }
sphere { 0, 1, }
sphere { 0, 1 pigment { rgb 1, } }
sphere { 0, 1 pigment { rgb 1, 2, 3 } }
sphere { 0, 1 pigment { rgb 0.1, sin(1), 2 } }
sphere { 0, 1 pigment { rgb 0.1, clock, 2 } }
