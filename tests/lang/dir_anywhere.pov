// A directive may stand between any two tokens, in the midst of a vector or behind a colour word.
#version 3.7;
#declare A = rgb #debug "behind rgb\n" < #debug "behind <\n" 1, #declare B = 2; B, 3 >;
#debug concat(vstr(3, A, ",", 0, 0), "\n")
sphere #debug "behind sphere\n" { 0, 1 #if (0) translate x #else scale 2 #end pigment #debug
	"behind pigment\n" { A } }
