// Highlights, reflection and the rest of finish.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
sphere { <-1.1, 0, 0>, 1 pigment { rgb <1, .6, .3> }
	finish { ambient rgb .2 diffuse .5 brilliance 3 phong .6 phong_size 80 specular .4 roughness .02 metallic .7
		reflection { .1, .6 falloff 2 metallic } } }
sphere { <1.1, 0, 0>, 1 pigment { rgb <1, .6, .3> }
	finish { emission .1 phong albedo .1 phong_size 30 specular albedo .1 diffuse albedo .5, .2 conserve_energy } }
plane { y, -1.01 pigment { checker }
	finish { reflection { .1 fresnel exponent .8 } irid { .35 thickness .4 turbulence .3 } diffuse albedo .6 } interior { ior 1.5 } }
