// views: D=4,S=1 D=1000,S=1 D=1e5,S=1 D=1e6,S=1
#include "view.inc"
Show(torus { 1, 0.3 })
