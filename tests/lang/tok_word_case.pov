// Words are case-sensitive; the underscore may begin one.
#version 3.7;
#declare _a = 1; #declare _A = 2; #declare Sphere = 3; #declare a_1b2 = 4;
#debug concat(vstr(4, <_a, _A, Sphere, a_1b2>, " ", 0, 0), "\n")
