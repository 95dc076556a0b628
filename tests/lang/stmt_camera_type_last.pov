// The type of a camera comes first.
#version 3.7;
camera { location -5*z orthographic }
