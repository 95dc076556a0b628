// A scene of a version before 3.5 to its end.
#version 3.1;
global_settings { assumed_gamma 1 }
sphere { 0, 1 }
