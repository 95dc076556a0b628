#debug concat(str(version, 0, 2), "\n")
#version 3.5;
#debug concat(str(version, 0, 2), "\n")
#declare Save = version;
#version unofficial 3.6;
#debug concat(str(version, 0, 2), "\n")
#version Save;
#debug concat(str(version, 0, 2), "\n")
#version 3.1;
#declare A = 5
#declare B = A + 1
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
#version 3.7;
# /* comments may stand here */ debug // and here
	"spaced\n"
#debug concat(str(1e, 0, 0), str(1.5e+, 0, 1), str(.5, 0, 1), str(007, 0, 0), str(1., 0, 0), str(1e3, 0, 0), "\n")
/* nested /* comments */ */
#debug concat(str(yes + on + true, 0, 0), str(no + off + false, 0, 0), "\n")
