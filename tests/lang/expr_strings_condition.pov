// A relation of strings is a float.
#version 3.7;
#declare S = "x";
#if (S = "x") #debug "equal\n" #end
#if ((S = concat("", "x")) & 1) #debug "and\n" #end
#debug concat(str((("a" < "b") + 1), 0, 0), str(("a" = "b" ? 1 : 2), 0, 0), "\n")
