// views: D=4,S=1 D=1000,S=1 D=1e5,S=1 D=1e6,S=1
#include "view.inc"
Show(superellipsoid { <0.4, 0.3> })
