// A reserved word is never a declared identifier.
#version 3.7;
#ifdef (sphere) #debug "declared\n" #else #debug "not declared\n" #end
#debug concat(str(defined(pi), 0, 0), str(defined(image_width), 0, 0), "\n")
