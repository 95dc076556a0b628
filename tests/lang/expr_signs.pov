// Prefix signs: + is ignored, - and ! may be repeated.
#version 3.7;
#debug concat(str(--3, 0, 0), str(-+-4, 0, 0), str(!!5, 0, 0), str(-!0, 0, 0), str(!-1, 0, 0), "\n")
#debug concat(str(2*-3, 0, 0), str(2 - -3, 0, 0), str(2 + +3, 0, 0), str(2--3, 0, 0), "\n")
