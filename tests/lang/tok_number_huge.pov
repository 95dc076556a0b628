// Numbers beyond binary64 are infinite or 0.
#version 3.7;
#debug concat(str(1e400, 0, 0), " ", str(-1e400, 0, 0), " ", str(1e-400, 0, 3), "\n")
