// The parenthesis of a call is missing.
#version 3.7;
#macro Ball(A, B) sphere { A, B } #end
Ball(1, 2
box { 0, 1 }
