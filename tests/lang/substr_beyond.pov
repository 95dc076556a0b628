// lambert goes on behind each of these, and reports them all.
#version 3.7;
#declare A = concat(substr("abc", 0, 5), "");
#declare B = concat(substr("abc", 5, 0), "");
#declare C = concat(substr("abc", -1, 1), "");
#declare D = concat(substr("abc", 2, -1), "");
#declare E = concat(substr("abc", 4, 1), "");
sphere { 0, 1 }
