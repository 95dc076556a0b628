// A component may be selected from any operand.
#version 3.7;
#declare A = array[2] { <1, 2, 3>, <4, 5, 6> }
#declare B = <1, 1, 1>;
#debug concat(str((A[1] - B).y, 0, 0), str(A[0].z, 0, 0), str(vcross(x, y).z, 0, 0), str(<7, 8,
	9>.x, 0, 0),
	str(vnormalize(<0, 3, 0>).y, 0, 0), str(-A[1].x, 0, 0), "\n")
