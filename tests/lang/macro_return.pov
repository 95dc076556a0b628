// The final identifier is read as the value before the locals go.
#version 3.7;
#macro Mean(A, B) #local R = (A + B)/2; R #end
#declare M = Mean(1, 4);
#macro Name(A) #local S = concat("<", A, ">"); S #end
#macro Ball(A) #local O = box { 0, A } O #end
#declare N = Name("a");
#declare O = object { Ball(3) }
#debug concat(str(M, 0, 1), N, str(max_extent(O).x, 0, 0), "\n")
