// A list that has its own objects cannot be linked to the other.
#version 3.7;
sphere { 0, 1 clipped_by { sphere { 0, 2 } } bounded_by { box { -1, 1 } } bounded_by { clipped_by } }
