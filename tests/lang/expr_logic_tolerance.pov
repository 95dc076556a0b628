// The operands of & | ! are true beyond the tolerance of 1e-10.
#version 3.7;
#debug concat(str((1e-11 | 0), 0, 0), str((1e-9 & -3), 0, 0), str(!1e-11, 0, 0), str(!0.5, 0, 0),
	"\n")
