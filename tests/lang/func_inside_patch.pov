// A triangle has no inside.
#version 3.7;
#declare O = triangle { x, y, z }
#declare F = inside(O, 0);
