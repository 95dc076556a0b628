// They count as declared; words of the language do not.
#version 3.7;
#debug concat(str(defined(image_width), 0, 0), str(defined(no_such_name), 0, 0), "\n")
#ifdef (clock_delta) #debug "declared\n" #end
