// At statement level declare, include and default work without '#'.
#version 3.7;
declare A = 5;
include "dir_bare.inc"
default { finish { ambient 1 } }
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
