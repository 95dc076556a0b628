// Words the samples never use: select, strcmp, #range, #elseif, file_exists, defined.
#declare V = select(-1, 1, 2, 3); #declare W = select(0, 1, 2);
#debug concat(str(V,0,0), str(W,0,0), "\n")
#if (strcmp("abc","abd") < 0) #debug "less\n" #end
#switch (7) #range (1,3) #debug "1-3\n" #break #range (5,8) #debug "5-8\n" #break #else #debug "else\n" #end
#if (0) #elseif (file_exists("colors.inc")) #debug "exists\n" #else #debug "no\n" #end
#ifdef (V) #debug "defd\n" #end #debug str(defined(Q),0,0) #debug "\n"
#debug concat(strupr("abc"), strlwr("DEF"), substr("hello",2,3), chr(65), str(asc("A"),0,0), str(val("3.5e1"),0,2), "\n")
