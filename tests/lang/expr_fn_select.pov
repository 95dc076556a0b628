// select of three and of four values; all are evaluated.
#version 3.7;
#macro M(X) #debug concat(str(select(X, 1, 2), 0, 0), str(select(X, 1, 2, 3), 0, 0), " ") #end
M(-1) M(0) M(1) M(1e-11) M(-1e-11)
#declare R = seed(1);
#declare A = select(1, rand(R), 5);
#debug concat(str(rand(R), 0, 6), "\n")
