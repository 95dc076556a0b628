// A smooth_triangle whose normals oppose each other, or one of which is zero, is left out with a warning.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Opposed = smooth_triangle { <-3,2,0>, z, <-2,2,0>, -z, <-2.5,3,0>, -z }
#declare Zero = smooth_triangle { <-1,2,0>, 0, <0,2,0>, -z, <-0.5,3,0>, -z }
object { Opposed }
object { Zero }
sphere { 0, 1 }
camera { location -5*z look_at 0 }
