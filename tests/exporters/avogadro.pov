// Form of Avogadro: location, angle, up, right, direction in this order; fade_power 0, parallel lights, `metallic 0.5`.
global_settings {
	ambient_light rgb <0.2, 0.2, 0.2>
	max_trace_level 15
}
background { color rgb <0.1, 0.1, 0.2> }
camera {
	perspective
	location <0.5, 0.8, 6>
	angle 40
	up <0, 1, 0>
	right <1, 0, 0> * 1.3333
	direction <0, 0, -1> }
light_source {
	<4, 6, 8>
	color rgb <1, 1, 1>
	fade_distance 12
	fade_power 0
	parallel
	point_at <-4, -6, -8>
}
#default {
	finish {ambient .8 diffuse 1 specular 1 roughness .005 metallic 0.5}
}
sphere {
	<-0.6, 0.2, 0>, 0.8
	pigment { rgbt <0.5, 0.5, 0.55, 0> }
}
cylinder {
	<-0.6, 0.2, 0>,	<1.2, -0.3, 0.4>, 0.2
	pigment { rgbt <0.8, 0.2, 0.2, 0.0> }
}
