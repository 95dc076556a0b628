#version 3.7;
#declare Sweep = sphere_sweep { linear_spline, 2, -x, 1, x, 1 }
sphere { , 0, 1 }
fog { <1, 1, 1> distance 3 }
text { "timrom.ttf" "a" 1, 0 }
#declare A = array[2] { +t, t }
