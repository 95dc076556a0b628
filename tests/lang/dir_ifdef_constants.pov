// Numbers, strings and reserved words are no declared identifiers.
#version 3.7;
#ifdef (5) #debug "wrong\n" #else #debug "number\n" #end
#ifdef ("s") #debug "wrong\n" #else #debug "string\n" #end
#ifdef (true) #debug "wrong\n" #else #debug "reserved\n" #end
#debug concat(str(defined(5) + defined("s"), 0, 0), "\n")
