// Bounds that the author gives to objects that have their own; not of what stays one object, has an
// infinite part, or is only declared.
#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 bounded_by { box { -1, 1 } } }
union { sphere { 0, 1 } sphere { x, 1 } bounded_by { sphere { 0, 3 } } }
object { union { box { 0, 1 } torus { 2, 1 } } bounded_by { box { -4, 4 } } }
difference { sphere { 0, 1 } box { 0, 1 } bounded_by { sphere { 0, 1 } } }
union { sphere { 0, 1 } plane { y, -5 } bounded_by { sphere { 0, 1 } } }
quadric { <1, 1, -1>, 0, 0, -1 clipped_by { box { -3, 3 } } bounded_by { clipped_by } }
union { sphere { 0, 1 } box { 0, 1 } clipped_by { plane { y, 0 } } bounded_by { clipped_by } }
#declare Unused = sphere { 0, 1 bounded_by { box { -1, 1 } } }
