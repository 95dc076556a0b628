// A lone function identifier copies the function.
#version 3.7;
#declare F = function(a) { a + 1 }
#declare G = F;
#undef F
#debug concat(str(G(4), 0, 0), "\n")
