#version 3.7;
#declare P = pigment { rgb 1 }
#declare N = normal { bumps }
sphere { 0, 1 texture { N P finish { phong 1 } } }
sphere { 0, 1 texture { finish { phong 1 } P } }
