// views: D=4,S=1 D=4,S=0.01 D=40,S=1000 D=4,S=1e6
#include "view.inc"
Show(text { ttf "timrom.ttf" "S&g", 0.2, 0 translate <-0.8, -0.2, 0> })
