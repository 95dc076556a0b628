// Values that use values without end are stopped where it happens.
#version 3.7;
#declare P = pigment { rgb 1 }
#while (1)
	#declare P = pigment { P }
#end
