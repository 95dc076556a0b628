// A body may be half a statement, with a brace opened in a branch.
#version 3.7;
#macro Open(C) #if (C) union { #else merge { #end #end
#macro Close() } #end
Open(1) sphere { 0, 1 } sphere { x, 1 } Close()
Open(0) sphere { 0, 1 } sphere { x, 1 } Close()
#debug "passed\n"
