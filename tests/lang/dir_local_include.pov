// A #local of an include file is seen by the rest of it and what it calls, and gone then.
#version 3.7;
#declare G = 1;
#macro Seen() #debug concat(str(InFile, 0, 0), " seen by a macro called\n") #end
#include "dir_local_include.inc"
#debug concat(str(defined(InFile), 0, 0), str(G, 0, 0), "\n")
