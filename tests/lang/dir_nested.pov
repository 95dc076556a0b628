// 199 open blocks are allowed.
#version 3.7;
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) 
#if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1) #if
	(1) #if (1) #if (1) #if (1) #if (1) #if (1) #if (1)  #debug "deep\n" #end #end #end #end
	#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
#end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end #end 
