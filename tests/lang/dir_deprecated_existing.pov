// deprecated is ignored for a name that exists already.
#version 3.7;
#declare A = 1;
#declare deprecated "old" A = 2;
#debug concat(str(A, 0, 0), "\n")
