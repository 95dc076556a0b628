// x u red, y v green, z blue, t filter and transmit select components.
#version 3.7;
#declare C = <1, 2, 3, 4, 5>;
#debug concat(str(C.x + C.u + C.red, 0, 0), str(C.y + C.v + C.green, 0, 0), str(C.z + C.blue, 0, 0),
	str(C.t + C.filter, 0, 0), str(C.transmit, 0, 0), "\n")
#declare P = <7, 8>;
#debug concat(str(P.u, 0, 0), str(P.y, 0, 0), " ", str(x.x, 0, 0), " ", str(t.t, 0, 0), "\n")
