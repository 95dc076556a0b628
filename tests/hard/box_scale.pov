// views: D=4,S=1 D=4,S=0.01 D=40,S=1000 D=4,S=1e6
#include "view.inc"
Show(box { -0.8, 0.8 })
