// The extent of an object is asked of an identifier.
#version 3.7;
#declare V = max_extent(sphere { 0, 1 });
