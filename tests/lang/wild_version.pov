// A version by expression.
#version max(3.5, min(3.8 - 0.1, version));
#debug str(version,0,2)
#debug "\n"
