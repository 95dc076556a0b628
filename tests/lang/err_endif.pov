// A word of another language where #end should be.
#version 3.7;
#if (1)
	sphere { 0, 1 }
#else
	box { 0, 1 }
#endif
