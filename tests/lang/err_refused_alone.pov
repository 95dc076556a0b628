// A scene whose only object is refused is not said to have none.
#version 3.7;
global_settings { assumed_gamma 1 }
sphere_sweep { linear_spline 2, 0, 1, y, 1 }
