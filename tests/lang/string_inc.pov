// The functions of strings.inc.
#version 3.7;
#include "strings.inc"
#declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
#debug concat(VStr(<1, 2, 3>), " ", VStr2D(<1, 2>), " ", CRGBStr(C, 1, 2), "\n")
#debug concat(CRGBFTStr(C, 1, 2), Str(5), Vstr(<1, 2, 3>, 5, 1), "\n")
Parse_String("#debug \"parsed\\n\"")
#debug concat(Triangle_Str(x, y, z), "\n")
