// Functions that call each other: 4000 levels are enough.
#declare F = function(x) { x }
#for (I, 1, 2100)
	#declare G = function(x) { F(x) + 1 }
	#undef F
	#declare F = function(x) { G(x) }
	#undef G
#end
sphere { 0, 1 }
