// Both operands of | and & are evaluated always.
#version 3.7;
#declare R = seed(1);
#declare A = (1 | rand(R));
#declare A = (0 & rand(R));
#debug concat(str(rand(R), 0, 9), "\n")
