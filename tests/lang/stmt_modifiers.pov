// The modifiers of an object, switches with and without a value.
#version 3.7;
sphere { 0, 1 hollow no_shadow no_image no_reflection double_illuminate no_radiosity }
sphere { 0, 1 hollow off no_image on no_reflection (1 > 0) double_illuminate false inverse }
sphere { 0, 1 translate x rotate 90*y scale 2 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0> }
sphere { 0, 1 texture { pigment { rgb 1 } } interior_texture { pigment { rgb 0 } } interior { ior 1.5 } }
sphere { 0, 1 pigment { rgb 1 } normal { bumps 0.5 } finish { ambient 1 } material { interior { ior 2 } } }
sphere { 0, 1 photons { target 1 refraction on reflection off collect off pass_through } }
sphere { 0, 1 clipped_by { plane { x, 0 } } bounded_by { clipped_by } }
sphere { 0, 1 bounded_by { box { -1, 1 } } clipped_by { bounded_by } }
sphere { 0, 1 uv_mapping pigment { checker } radiosity { importance 0.5 } }
#debug "ok\n"
