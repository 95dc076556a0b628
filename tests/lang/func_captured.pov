// Identifiers give the value that they have when the function is declared.
#version 3.7;
#declare A = 3;
#declare B = array[2] { 5, 7 }
#declare F = function(x) { A*x + B[1] + pi - clock }
#declare A = 100;
#declare B[1] = 0;
#debug concat(str(F(2), 0, 9), "\n")
