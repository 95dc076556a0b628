// A camera that shears the picture, and ones that look along their sky or are the second.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { right x + 0.001*y }
camera { matrix <1, 0, 0, 0.2, 1, 0, 0, 0, 1, 0, 0, 0> }
camera { location 5*y look_at 0 }
camera { right 4/3*x direction 2*z look_at <1, 2, 3> rotate <10, 20, 30> }
sphere { 0, 1 }
