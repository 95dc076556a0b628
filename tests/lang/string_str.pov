// str: the width, zeros for a negative width, the precision, ties to the even digit.
#version 3.7;
#debug concat("[", str(2.5, 0, 0), "] [", str(3.5, 0, 0), "] [", str(-3.14159, -8, 2), "]\n")
#debug concat("[", str(pi, 8, 3), "]\n")
#debug concat("[", str(1/3, 0, -1), "] [", str(7.9, 3.9, 0.9), "] [", str(-0.0001, 0, 2), "]\n")
#debug concat("[", str(123456789, 3, 2), "] [", str(0.5, 0, 0), "] [", str(1e15/3, 0, 5), "]\n")
