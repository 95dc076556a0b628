// Form of Open Babel: an include file of its own, #version in the middle, colours without commas, #render.
#include "colors.inc"
#include "openbabel.inc"
background { color rgb <.95 .95 .95> }
#declare Carbon = rgb <.3 .35 .4>;
#declare Oxygen = rgb <.9 .1 .1>;
#version 3.6;
global_settings { ambient_light rgb <1.0 1.0 1.0> }
light_source { <3, 6, -8> color rgb <.9 .9 .9> }
#declare mol_0 = union {
 atom_at(<-.9, 0, 0>, Carbon, 1.0)
 atom_at(<.5, .3, -.2>, Oxygen, .9)
 atom_at(<1.2, -.8, .1>, rgb <.95 .9 .9>, .6)
 bond_between(<-.9, 0, 0>, <.5, .3, -.2>, rgb <.6 .6 .6>)
 bond_between(<.5, .3, -.2>, <1.2, -.8, .1>, rgb <.6 .6 .6>)
}
object { mol_0 rotate <0, 20, 0> }
camera { location <0, 0, -6> look_at <0, 0, 0> angle 40 }
#render "done\n"
