// The thousandth number of a stream.
#version 3.7;
#declare R = seed(123456);
#for (I, 1, 999) #declare Drop = rand(R); #end
#debug concat(str(rand(R), 0, 12), "\n")
