// SPDX-License-Identifier: MIT
// Everything light can do to a point at once; probe.expected has the numbers.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0,1,-4> look_at <0,.6,0> right x*4/3 angle 45 }
background { rgb <.2,.3,.5> }
light_source { <3,5,-4> rgb <1,.9,.8> fade_distance 6 fade_power 2 }
light_source { <-4,3,-2> rgb .4 spotlight point_at <0,.5,0> radius 8 falloff 20 tightness 3 }
sphere { <0,.7,0>, .7
	pigment { rgbft <.7,.9,.8,.5,.2> }
	finish { ambient .05 diffuse .4 phong .5 phong_size 30 reflection { .05, .5 fresnel }
		conserve_energy }
	interior { ior 1.4 fade_distance .8 fade_power 2 fade_color rgb <.4,.9,.6> }
}
plane { y, 0
	pigment { checker rgb .9 rgb <.3,.2,.1> }
	finish { ambient .1 diffuse .6 specular .2 roughness .02 reflection .1 }
}
fog { fog_type 2 color rgb <.6,.6,.7> distance 12 fog_offset .2 fog_alt .5 }
