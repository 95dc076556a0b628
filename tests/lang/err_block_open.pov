// A word that can only stand outside of the block shows where the block begins.
#version 3.7;
sphere { 0, 1
	pigment { rgb 1 }
	finish { ambient 1 }
box { 0, 1 }
