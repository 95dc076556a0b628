// The shapes of points and radii, commas between their items optional.
#version 3.7;
sphere { <0, 0, 0>, 1 } sphere { 0 1 }
box { <0, 0, 0>, <1, 1, 1> } box { 0 1 }
cylinder { 0, y, 1 } cylinder { 0 y 1 open }
cone { 0, 1, y, 0.5 } cone { 0 1 y 0 open }
torus { 2, 1 } torus { 2 0.5 sturm }
plane { y, 0 } plane { <1, 1, 0> 1 }
disc { 0, y, 1 } disc { 0 y 1 0.5 }
#debug "ok\n"
