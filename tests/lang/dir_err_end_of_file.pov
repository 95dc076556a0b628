// Blocks must be closed at the end of the scene.
#version 3.7;
#if (1)
	#ifdef (A) #end
	#switch (1) #case (1)
