// version is what was set last, in hundredths; it may be used in expressions.
#version 3.7;
#version 3.1;
#declare A = version;
#version 3.5;
#debug concat(str(A, 0, 3), " ", str(version, 0, 3), "\n")
#version A;
#debug concat(str(version*2, 0, 3), " ", str((version < 3.5), 0, 0), "\n")
#version 3.7;
