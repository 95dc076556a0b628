// A light source is no modifier of an object.
#version 3.7;
sphere { 0, 1 light_source { 9*y, 1 } }
