// #declare B = A copies: a change of A does not reach B.
#version 3.7;
#declare A = array[2] { 1, 2 } #declare B = A;
#declare A[0] = 9;
#declare S = "a"; #declare T = S; #declare S = "b";
#declare P = texture { pigment { rgb 1 } }
#declare Q = P
#debug concat(str(A[0], 0, 0), str(B[0], 0, 0), S, T, str(defined(Q), 0, 0), "\n")
