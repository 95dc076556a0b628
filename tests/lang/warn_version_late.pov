// A scene whose first #version comes from an include, with neither a version nor a gamma of its own.
#include "colors.inc"
sphere { 0, 1 pigment { Red } }
