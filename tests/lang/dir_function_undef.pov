// Behind #undef a function may be declared anew.
#version 3.7;
#declare F = function(x) { x }
#undef F
#declare F = function(x) { 2*x }
#undef F
#declare F = 7;
#debug concat(str(F, 0, 0), "\n")
