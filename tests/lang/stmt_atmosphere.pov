// background, fog, rainbow, sky_sphere.
#version 3.7;
background { rgb <0, 0, 0.1> }
fog { distance 100 rgbt <0.5, 0.5, 0.6, 0.2> fog_type 2 fog_offset 1 fog_alt 2 up y turbulence 0.2 turb_depth 0.3
	octaves 3 omega 0.5 lambda 2 }
#declare R = rainbow { direction -z angle 42.5 width 5 distance 1000 jitter 0.01 color_map {
	[0 rgbt 1] [1 rgbt 0.9] }
	up y arc_angle 120 falloff_angle 30 }
#declare S = sky_sphere { pigment { gradient y color_map { [0 rgb x]
	[1 rgb z] } } emission 0.9 rotate 5 }
sky_sphere { S }
#debug "ok\n"
