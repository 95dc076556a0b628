// An element may be a function, and another behind #undef.
#version 3.7;
#declare A = array[2];
#declare A[0] = function(x) { x + 1 }
#debug concat(str(A[0](1), 0, 0), "\n")
#undef A[0]
#declare A[0] = function(x) { 2*x }
#debug concat(str(A[0](4), 0, 0), "\n")
