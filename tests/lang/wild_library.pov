// The standard library in earnest.
#include "transforms.inc" #include "math.inc" #include "strings.inc" #include "arrays.inc" #include "shapes3.inc" #include "rand.inc"
sphere { 0,1 Point_At_Trans(x+y) Shear_Trans(x,y+x,z) }
#debug concat(vstr(3, VPerp_To_Plane(x,y), ",", 0, 3), "\n")
Parse_String("#declare FromString = 9;")
#debug concat(str(FromString,0,0),"\n")
#declare Arr = array[4] {4,2,3,1}
Sort_Array(Arr)
#debug concat(str(Arr[0],0,0),str(Arr[3],0,0),"\n")
object { Segment_of_CylinderRing( 1, 0.5, 0.5, 90 ) pigment { rgb 1 } }
#declare R = seed(3);
#debug concat(str(RRand(1,5,R),0,6), " ", vstr(3,VRand(R),",",0,6), " ", str(Rand_Normal(0,1,R),0,6), "\n")
#include "functions.inc"
#declare P = pigment { gradient x color_map { [0 rgb 0][1 rgb <1,0.5,0.25>] } }
#debug concat(vstr(3, eval_pigment(P, <0.5,0,0>), ",", 0, 4), "\n")
#declare D = array[2][2][2] { { {0, 0.5}, {1, 0.25} }, { {0.1,0.2},{0.3,0.4} } }
ARRAYS_WriteDF3(D, "wild.df3", 8)
