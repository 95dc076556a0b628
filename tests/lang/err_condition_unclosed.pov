// The parenthesis of a condition is missing.
#version 3.7;
#if (1 > 2
	box { 0, 1 }
#end
