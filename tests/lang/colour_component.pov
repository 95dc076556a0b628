// A component that the value does not have.
#version 3.7;
#declare V = <1, 2, 3>;
#declare F = V.transmit;
