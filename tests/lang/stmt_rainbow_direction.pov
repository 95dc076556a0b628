// A rainbow must know from where the light comes.
#version 3.7;
rainbow { angle 42 width 5 color_map { [0 rgb 1] [1 rgb 0] } }
