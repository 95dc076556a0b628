// The condition of ?: must be a float.
#version 3.7;
#declare A = (<1, 2, 3> ? 5 : 6);
