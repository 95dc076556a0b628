// A bare identifier first in a compound copies that object: no second may follow.
#version 3.7;
#declare S = sphere { 0, 1 }
#declare B = box { 0, 1 }
union { S B }
