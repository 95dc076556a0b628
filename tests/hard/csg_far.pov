// views: D=4,S=1 D=1000,S=1 D=1e5,S=1 D=1e6,S=1
#include "view.inc"
Show(difference { box { -0.8, 0.8 } sphere { 0, 1 } cylinder { -y, y, 0.3 } })
