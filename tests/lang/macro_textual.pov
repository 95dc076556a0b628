// The tokens of the body appear in place of the call.
#version 3.7;
#macro M() 1 + 2 #end
#macro L() 1, 7, 3 #end
#macro V() <1, 2, #end
#debug concat(str(M()*3, 0, 0), str((M())*3, 2, 0), str(max(L()), 2, 0), str((V() 3>).z, 2, 0),
	"\n")
