// Conditions: operators, ifdef, elseif, nested and skipped.
#version 3.7;
#declare A = 1;
#ifdef (A) #debug "A " #end
#ifndef (B) #debug "no B\n" #end
#if (A > 1) #debug "big\n" #elseif (A = 1) #debug "one\n" #else #debug "small\n" #end
#if (0) #if (1) #debug "never\n" #else #debug "never\n" #end #end
#debug concat(str((((1 < 2) & !(3 = 4)) | 0), 0, 0), " ", str((A > 0 ? 10 : 20), 0, 0), "\n")
