// How many elements a list says and has.
#version 3.7;
polygon { 1e9, <0, 0> }
polygon { -1, <0, 0> }
lathe { 3.7, <0, 0>, <1, 1> }
bicubic_patch { type 1 <0, 0, 0> }
poly { 4, <1, 2> }
