// A #local in a macro may have the name of a macro of the scene, which is there again afterwards.
// lambert only
#version 3.7;
global_settings { assumed_gamma 1 }
#macro V() 7 #end
#macro Hide() #local V = 3; #debug concat(str(V, 0, 0), "\n") #end
Hide()
#debug concat(str(V(), 0, 0), "\n")
sphere { 0, 1 }
