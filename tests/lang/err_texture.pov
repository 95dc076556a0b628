#version 3.7;
global_settings { assumed_gamma 1 }
#declare Unused = pigment { image_pattern { png "x.png" } color_map { [0 rgb 1] } }
sphere { 0, 1 pigment { average } }
sphere { 0, 1 texture { gradient x } }
sphere { 0, 1 texture { checker texture {} texture {} } texture { pigment { rgb 1 } } }
sphere { 0, 1 pigment { rgb 1 color_map { [0 rgb 1] } } }
sphere { 0, 1 pigment { checker color_map { [0 rgb 1] } } }
sphere { 0, 1 normal { scale 2 } }
sphere { 0, 1 pigment { gradient x warp { repeat 0 } } }
sphere { 0, 1 pigment { mandel 5 exterior 9, 1 } }
sphere { 0, 1 pigment { bozo agate_turb 2 } }
sphere { 0, 1 pigment { image_pattern { png "x.png" } color_map { [0 rgb 1] } } }
sphere { 0, 1 finish { subsurface { translucency 1 } } }
