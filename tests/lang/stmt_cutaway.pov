// cutaway_textures belongs to an intersection or a difference.
#version 3.7;
union { sphere { 0, 1 } sphere { x, 1 } cutaway_textures }
