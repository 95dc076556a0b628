// A vector has at least two components.
#version 3.7;
#declare A = <1>;
