// An element can be emptied and asked for.
#version 3.7;
#declare A = array[2] { 1, 2 }
#undef A[1]
#debug concat(str(defined(A[0]), 0, 0), str(defined(A[1]), 0, 0), str(defined(A), 0, 0), "\n")
#ifdef (A[1]) #debug "set\n" #else #debug "empty\n" #end
