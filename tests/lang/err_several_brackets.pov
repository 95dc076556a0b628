// Behind a brace within parentheses no statement begins.
#version 3.7;
#declare T = trace(sphere { 0, 1 }, 0, z);
#declare M = min_extent(plane { y, 0 });
box { 0, Foo }
