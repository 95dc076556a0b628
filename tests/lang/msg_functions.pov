// Errors in functions, one after the other.
#version 3.7;
#declare Pigment = function { pigment { rgb 1 } }
#declare A = function(x) { x 2 }
#declare B = function(x) { x + }
#declare C = function(x) { (x + 1 }
#declare D = function(x) { sin(x, 1) }
#declare E = function(x) { Pigment(x, 0, 0).nomember }
#declare F = function(x) { x / 0 }
#declare G = function(x) { x ^ 2 }
#declare H = function(x) { nothing_known(x) }
#declare I = function(x) { I(x) }
#declare J = function(x) { "text" }
sphere { 0, 1 pigment { function(x) { x } } }
