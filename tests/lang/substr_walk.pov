// Long strings are walked on from where the last substr was: forwards, backwards, two at a time, and
// after others have been made.
#version 3.7;
global_settings { assumed_gamma 1 charset utf8 }
#declare A = "";
#declare B = "";
#for (I, 0, 99)
	#declare A = concat(A, chr(65 + mod(I, 26)), chr(200 + I));
	#declare B = concat(B, chr(97 + mod(I, 26)));
#end
#declare Sum = 0;
#for (I, 1, strlen(A))
	#declare Sum = Sum + I*asc(substr(A, I, 1)) + asc(substr(B, div(I + 1, 2), 1));
#end
#for (I, strlen(A), 1, -1)
	#declare Sum = Sum - 2*I*asc(substr(A, I, 1));
#end
#debug concat(str(Sum, 0, 0), " ", substr(B, 99, 2), substr(B, 1, 3), substr(B, 50, 51), "\n")
#declare B = concat(substr(B, 2, 99), "!");
#debug concat(substr(B, 1, 2), substr(B, 100, 1), str(strlen(B), 0, 0), "\n")
sphere { 0, 1 }
