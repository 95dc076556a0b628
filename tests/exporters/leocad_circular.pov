// refused: a float is wanted here, not a vector
// Form of LeoCAD, its circular area light: vectors are compared with `=`, which POV-Ray refuses.
#version 3.7;
#declare AxisX = x;
#declare AxisY = y;
#if (AxisX = AxisY) #declare Same = 1; #end
camera { location -5 * z look_at 0 }
sphere { 0, 1 }
