// A 3-vector has no component filter.
#version 3.7;
#declare V = <1, 2, 3>;
#declare A = V.filter;
