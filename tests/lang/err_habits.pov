// What other languages have, and the usual slips.
#version 3.7;
#declare S = "a" + "b";
#declare S = concat("a","b") + "c";
sphere { 0, 1 rotate 90x }
sphere { 0, 1 rotate 1.5 y }
#declare F = function(t) { t*2 }
#declare F = function(u,clock) { u*2 }
#declare S = str(5);
#declare S = substr("abc", 1, 2, 3);
sphere { 0.5, <0, 3, 0> }
torus { 1, <1, 2> }
