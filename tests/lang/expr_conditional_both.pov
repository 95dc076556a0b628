// Both branches of ?: are evaluated.
#version 3.7;
#declare R = seed(1);
#declare A = (1 ? 5 : rand(R));
#debug concat(str(rand(R), 0, 9), "\n")
