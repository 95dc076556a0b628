#version 3.7;
#declare P = pigment { rgb 1 }
#declare M = pigment_map { [P] [1 P] }
sphere { 0, 1 pigment { average pigment_map { [P] [2 P] } } }
sphere { 0, 1 pigment { gradient x pigment_map { [P] [1 P] } } }
sphere { 0, 1 pigment { gradient x pigment_map { M } } }
