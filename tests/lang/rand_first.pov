// A stream begins with its seed; the answers are the states over 4294967295.
#version 3.7;
#declare R = seed(1);
#debug concat(str(rand(R), 0, 15), " ", str(rand(R), 0, 12), " ", str(rand(R), 0, 12), "\n")
