// concat needs at least one string.
#version 3.7;
#declare S = concat();
