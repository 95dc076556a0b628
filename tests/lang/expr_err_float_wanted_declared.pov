// A vector identifier where a float is wanted is an error.
#version 3.7;
#declare V = x;
#declare A = <V, 1, 2>;
