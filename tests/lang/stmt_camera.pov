// Cameras of all kinds.
#version 3.7;
#declare C = camera { perspective location -5*z look_at 0 angle 45 up y right x*4/3 sky y direction z }
#declare D = camera { orthographic location -5*z look_at 0 up 2*y right 3*x }
#declare D = camera { fisheye angle 180 }
#declare D = camera { ultra_wide_angle angle 120 }
#declare D = camera { omnimax }
#declare D = camera { panoramic angle 150 }
#declare D = camera { cylinder 1 angle 90 }
#declare D = camera { spherical angle 360, 180 }
#declare D = camera { location -5*z aperture 0.4 blur_samples 4, 10 focal_point 0 confidence 0.9 variance 0.01 }
#declare D = camera { location -z normal { bumps 0.1 } rotate x }
camera { C translate x }
#debug "ok\n"
