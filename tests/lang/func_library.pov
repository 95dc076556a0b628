// The functions of one and two arguments.
#version 3.7;
#declare A = function(x) { sin(x) + 2*cos(x) + 3*tan(x) + 4*asin(x) + 5*acos(x) + 6*atan(x) }
#declare B = function(x) { sinh(x) + 2*cosh(x) + 3*tanh(x) + 4*asinh(x) + 5*acosh(x + 1) + 6*atanh(x) }
#declare C = function(x) { abs(-x) + 2*degrees(x) + 3*radians(x) + 4*int(x*10) + 5*floor(-x) + 6*ceil(x) }
#declare D = function(x) { sqrt(x) + 2*exp(x) + 3*ln(x) + 4*log(x) }
#declare E = function(x, y) { atan2(x, y) + 10*mod(x*9, y) + 100*div(9*x, y) + pow(x, y) }
#declare M = function(x, y) { min(x, y, 3) + 10*max(x, y, 0.1) }
#debug concat(str(A(0.3), 0, 12), " ", str(B(0.3), 0, 12), " ", str(C(0.3), 0, 12), "\n")
#debug concat(str(D(0.3), 0, 12), " ", str(E(0.3, -1.1), 0, 12), " ", str(M(0.3, 1.1), 0, 12), "\n")
