// Strings are compared code by code where a comparison may stand.
#version 3.7;
#declare S = "abc";
#if (S = "abc") #debug "same\n" #end
#if (S < "abd") #debug "before\n" #end
#if ("B" < "a") #debug "capitals first\n" #end
#declare F = (S >= "ab") + 10*(S != concat("a", "bc")) + 100*("" <= "a");
#debug concat(str(F, 0, 0), "\n")
