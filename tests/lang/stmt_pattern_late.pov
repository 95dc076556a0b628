// The pattern comes first in a pigment.
#version 3.7;
sphere { 0, 1 pigment { scale 2 bozo } }
