// lambert only: POV-Ray counts to the end.
// Octaves and tubes by the million: what is counted ends at 10000.
#include "functions.inc"
#declare Huge = array[4] { 10000, 1e10, 1e300, 1e300*1e300 }
#for (I, 0, 3)
	#debug concat(str(f_ridge(.3, .4, .5, 2, Huge[I], .5, .1, .4, 2), 0, 4), " ",
		str(f_hetero_mf(.3, .4, .5, 1, 2, Huge[I], .5, 1, 2), 0, 4), " ",
		str(f_hetero_mf(.3, .4, .5, 1, 2, 3, .5, Huge[I], 2), 0, 4), " ",
		str(f_ridged_mf(.3, .4, .5, 1, 2, Huge[I], .5, 2, 2), 0, 4), " ",
		str(f_polytubes(.3, .4, .5, Huge[I], .5, .1, 0, 0, 0), 0, 4), "\n")
#end
#debug concat(str(f_noise_generator(.3, .4, .5, 1e300), 0, 4), " ", str(f_noise_generator(.3, .4, .5, 0), 0, 4), "\n")
sphere { 0, 1 }
