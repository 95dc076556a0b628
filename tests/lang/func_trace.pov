// trace: the hit and its normal, <0, 0, 0> for none.
#version 3.7;
#declare O = union { sphere { 0, 1 } box { <2, -1, -1>, <3, 1, 1> } rotate 10*y }
#declare N = <9, 9, 9>;
#declare P = trace(O, <-5, 0.25, 0.1>, x, N);
#debug concat(vstr(3, P, " ", 0, 9), "|", vstr(3, N, " ", 0, 9), "\n")
#declare P = trace(O, <2.5, 5, -0.2>, -y*3, N);
#debug concat(vstr(3, P, " ", 0, 9), "|", vstr(3, N, " ", 0, 9), "\n")
#declare P = trace(O, <0, 5, 0>, y, N);
#debug concat(vstr(3, P, " ", 0, 9), "|", vstr(3, N, " ", 0, 9), " ",
	str(trace(O, -5*z, z).z, 0, 6), "\n")
