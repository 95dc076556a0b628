// In the manner of scenes found in the wild: café ü, CRLF, no #version.
#include "colors.inc"
#declare S = "naïve";
#debug concat(S, str(strlen(S),0,0), "\n")
sphere { 0, 1 pigment { Red } }
