// lambert only: a macro may give back a value from within an #if, whatever follows.
#version 3.7;
#macro F(C) #if (C) 10 #else 20 #end #end
#declare A = F(1);
#declare B = F(0);
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
#if (F(1) = 10) #debug "compared\n" #end
#macro G(C) #switch (C) #case (1) 5 #break #else 6 #end #end
#declare D = (G(1) + G(2));
#debug concat(str(D, 0, 0), "\n")
