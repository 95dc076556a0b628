// A minus behind a value subtracts: where a value is missing then, the message says so.
#version 3.7;
global_settings { assumed_gamma 1 }
plane { y -0.5 pigment { rgb 1 } }
quadric { <1,1,1> <0,0,0> <0,0,0> -1 }
box { <1,1,1> -<2,2,2> }
cone { 0 -1, 2, 3 }
cylinder { x -x 1 }
sphere { <1 -2 -3>, 1 }
torus { 1 +0.5 }
prism { 0 -1, 3, <0,0>, <1,1>, <0,1> }
polygon { 3, x, y -x }
disc { 0 -y, 1 }
superellipsoid { <1 -2> }
cubic { <1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1, 1 -1> }
sphere { 0, 1 matrix <1,0,0,0,1,0,0,0,1,0,0 -1> }
blob { sphere { 0 -1, 1 } }
#declare V = vrotate(x -y);
#declare A = array[2] { 1 -2 }
#macro Floor(N) plane { N -0.5 } #end
object { Floor(y) }
#declare W = vrotate(x - y);
