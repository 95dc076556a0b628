// The nearest name of a kind that fits, not the nearest of all.
#version 3.7;
#declare Text1 = "a";
#declare Test = 1;
sphere { 0, 1 translate Texti }
