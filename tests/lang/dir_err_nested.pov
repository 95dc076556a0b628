// There are at most 199 open blocks.
#version 3.7;
#macro M(N)
	#if (N) #if (N) #if (N) M(N - 1) #end #end #end
#end
M(60)
