// Strings have no components.
#version 3.7;
#declare S = "a";
#declare A = S.x;
