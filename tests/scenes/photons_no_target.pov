// Settings of photons, of a lamp and of objects that are no targets: nothing is shot.
#version 3.7;
global_settings { assumed_gamma 1 photons { count 20000 media 10, 1 max_trace_level 8 } }
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 8, -5>, 1 photons { reflection on refraction on area_light } }
#declare Unused = sphere { 0, 1 photons { target } }
sphere { 0, 1 pigment { rgbf <1, 0.7, 0.4, 0.8> } finish { reflection 0.3 } interior { ior 1.5 }
	photons { reflection on refraction on collect off } }
plane { y, -1 pigment { checker rgb 1, rgb 0.3 } photons { pass_through } }
