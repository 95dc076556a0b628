// An element that is a function must be #undef'ed first.
#version 3.7;
#declare A = array[1];
#declare A[0] = function(x) { x }
#declare A[0] = function(x) { 2*x }
