// background cannot be declared.
#version 3.7;
#declare A = background { rgb 1 }
