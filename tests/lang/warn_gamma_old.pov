// Before version 3.7 a scene without assumed_gamma has no gamma handling at all.
#version 3.6;
sphere { 0, 1 }
