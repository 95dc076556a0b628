// = != <= >= have a tolerance of 1e-10, < and > none.
#version 3.7;
#declare B = 1 + 5e-11;
#debug concat(str((1 = B), 0, 0), str((1 != B), 0, 0), str((1 < B), 0, 0), str((B > 1), 0, 0),
	str((1 >= B), 0, 0),
	str((B <= 1), 0, 0), "\n")
#declare B = 1 + 2e-10;
#debug concat(str((1 = B), 0, 0), str((1 != B), 0, 0), str((1 >= B), 0, 0), str((B <= 1), 0, 0),
	"\n")
