// A union made of itself twice, 40 times over.
#version 3.7;
#declare O = sphere { 0, 1 }
#declare I = 0;
#while (I < 40)
	#declare O = union { object { O } object { O translate x } }
	#declare I = I + 1;
#end
object { O }
