// Skipped text is read as tokens: words are not looked up, blocks are counted.
#version 3.7;
#if (0)
	undeclared words "#end" /* #end */ // #end
	#if (x) #else #elseif #end #ifdef () #end #ifndef #end #while #end #for #end #switch #case
		#range #break #end
	#macro #end #declare #local 1.5e3 #include #version ) } ]
#else
	#debug "else\n"
#end
