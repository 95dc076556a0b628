// Objects come before the modifiers of their union.
#version 3.7;
union {
	sphere { 0, 1 }
	translate x
	sphere { x, 1 }
}
