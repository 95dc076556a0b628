// A macro may be defined anew.
#version 3.7;
#macro M() 1 #end
#macro N() M() #end
#debug str(N(), 0, 0)
#macro M() 2 #end
#debug concat(str(N(), 0, 0), "\n")
