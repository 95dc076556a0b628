// The text ends where a value must stand.
#version 3.7;
#declare A =
