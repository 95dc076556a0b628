// An area light has at least one row.
#version 3.7;
light_source { 9*y, 1 area_light x, z, 0, 3 }
