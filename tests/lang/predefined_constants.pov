// The words for 1 and 0, and the unit vectors.
#version 3.7;
#debug concat(str(true, 0, 0), str(yes, 0, 0), str(on, 0, 0), str(false, 0, 0),
	str(no, 0, 0), str(off, 0, 0), "\n")
#debug concat(vstr(3, x, "", 0, 0), vstr(3, y, "", 0, 0), vstr(3, z, "", 0, 0), vstr(4, t,
	"", 0, 0), "\n")
#debug concat(vstr(2, u, "", 0, 0), vstr(2, v, "", 0, 0), "\n")
