// Components that a value does not have print as 0.
#version 3.7;
#debug concat(vstr(3, 5, ",", 0, 0), " ", vstr(5, <1, 2>, ",", 0, 0), "\n")
