// Colours that are left out of items are black; a reflection without braces changes nothing then.
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength }
camera { location <0, 1, -6> look_at 0 angle 50 }
light_source { <5, 5, -5> 1 }
plane { y, -1 pigment { checker rgb <1, 0.2, 0.1> rgb 0.9 } }
sky_sphere { pigment { rgb <0.2, 0.4, 0.9> } }
#default { finish { reflection 0.7 } }
sphere { <-2, 1, 0>, 0.8 pigment { rgb 0.3 } finish { reflection } }
sphere { <0, 1, 0>, 0.8 pigment { rgb 0.3 } finish { reflection { } } }
sphere { <2, 1, 0>, 0.8 pigment { rgb 0.3 } finish { reflection { , 1 } } }
sphere { <-2, -0.5, -1>, 0.6 pigment { rgb 0.3 } finish { reflection { fresnel } } interior { ior 1.5 } }
sphere { <0, -0.5, -1>, 0.6 pigment { rgb 0.3 } finish { reflection { , } phong 1 } }
sphere {
	<2, -0.5, -1>, 0.6
	pigment { rgbf 0.7 }
	finish { reflection 0 }
	interior { ior 1.3 fade_distance 1 fade_power 1 fade_color }
}
