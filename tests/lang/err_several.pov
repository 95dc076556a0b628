// Faulty statements that are independent are each reported; what follows from them is not.
#version 3.7;
#declare Good = 1;
sphere { 0, 1 pigmet { rgb 1 } }
#declare Bad = Gud + 1;
box { -Bad, 1 }
cylinder { 0, Bad, 1 texture { T } }
#declare Coat = texture { pigment { rgb Wite } } texture { pigment { rgb 1 } }
sphere { 0, 1 texture { Coat } }
#if (Good)
	union { sphere { 0, Good.y } #for (I, 1, 3) box { 0, I } #end }
#else
	union {
#end
#macro Ball(R) sphere { 0, Wrong } #end
Ball(1)
Ball(2)
torus { Good, sin("a") }
