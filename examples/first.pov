// A first picture: marbles on a wooden table by a misty sea.
//
// Try it: change a number, render again. The ones worth changing first have names.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

#declare Marbles = 34;
#declare Sun = <-6, 7, -4>;

camera { location <0.5, 2.05, -6.9> look_at <0.02, 1.12, 0> right x * image_width / image_height angle 42 }
light_source { 100 * Sun rgb <1.7, 1.5, 1.25> }
light_source { <40, 30, -60> rgb <0.14, 0.18, 0.26> shadowless }

// Sky, clouds, and mist over the water.
sky_sphere {
	pigment { gradient y color_map {
		[0 rgb <0.95, 0.8, 0.66>] [0.08 rgb <0.62, 0.73, 0.86>] [0.5 rgb <0.12, 0.28, 0.6>] } }
	pigment { bozo turbulence 0.65 octaves 6 lambda 2.3 omega 0.55 color_map {
		[0.5 rgbt 1] [0.7 rgbt <1, 0.97, 0.94, 0.35>] [1 rgbt <0.9, 0.9, 0.93, 0.1>] }
		scale <0.45, 0.1, 0.45> }
}
plane { y, -3
	pigment { rgb <0.02, 0.06, 0.08> }
	normal { bumps 0.14 scale <2.4, 1, 0.9> }
	finish { ambient 0 diffuse 0.4 reflection { 0.1, 0.9 falloff 3 } specular 0.5 roughness 0.005 }
}
fog { fog_type 2 distance 150 rgb <0.9, 0.84, 0.78> fog_offset -3 fog_alt 0.7 }

// The table: planks of one wood, cut from different places of the log.
#declare Plank = pigment { wood turbulence <0.06, 0.05, 0.5> octaves 4 color_map {
	[0 rgb <0.42, 0.21, 0.09>] [0.6 rgb <0.33, 0.15, 0.06>] [0.9 rgb <0.2, 0.085, 0.035>] [1 rgb <0.4, 0.2, 0.085>] }
	scale <0.14, 0.14, 1.6> rotate <1.5, 88, 0> }
#for (I, -4, 3)
	intersection {
		box { <-4, -0.3, 0.62 * I + 0.01>, <4, 0, 0.62 * I + 0.61> }
		plane { y, 0 rotate x * -45 translate <0, -0.012, 0.62 * I + 0.012> }
		plane { y, 0 rotate x * 45 translate <0, -0.012, 0.62 * I + 0.608> }
		pigment { Plank translate <1.9 * I, 0.37 * I, 0.53 * I> }
		finish { ambient 0.05 diffuse 0.8 specular 0.25 roughness 0.02 reflection { 0, 0.35 fresnel } conserve_energy }
		interior { ior 1.5 }
	}
#end

// A granite stand: a block with a bowl scooped out and round windows, on a slab.
#declare Granite = texture {
	pigment { granite scale 0.6 color_map {
		[0 rgb <0.1, 0.09, 0.1>] [0.35 rgb <0.42, 0.38, 0.38>] [0.65 rgb <0.66, 0.58, 0.55>] [1 rgb <0.93, 0.88, 0.84>] } }
	finish { ambient 0.05 diffuse 0.75 specular 0.5 roughness 0.015 reflection 0.06 }
}
union {
	difference {
		box { <-0.75, 0.1, -0.75>, <0.75, 0.95, 0.75> }
		sphere { <0, 1.5, 0>, 0.88 }
		cylinder { <-1, 0.42, 0>, <1, 0.42, 0>, 0.22 }
		cylinder { <0, 0.42, -1>, <0, 0.42, 1>, 0.22 }
	}
	box { <-0.9, 0, -0.9>, <0.9, 0.1, 0.9> }
	texture { Granite }
	rotate y * 28
	translate z * 0.3
}

// A glass ball in the bowl, one of polished metal beside it, a ring leaning on the stand.
sphere { <0, 1.45, 0.3>, 0.8
	pigment { rgbf <0.97, 1, 0.98, 0.97> }
	finish { ambient 0 diffuse 0.02 specular 0.8 roughness 0.002 reflection { 0, 1 fresnel } conserve_energy }
	interior { ior 1.5 fade_distance 2.2 fade_power 2 fade_color rgb <0.55, 0.9, 0.8> }
}
sphere { <1.75, 0.52, -0.55>, 0.52
	pigment { rgb <0.9, 0.62, 0.3> }
	finish { ambient 0 diffuse 0.2 specular 0.9 roughness 0.004 metallic reflection { 0.75 metallic } }
}
torus { 0.5, 0.09 rotate <62, 0, 0> rotate y * 30 translate <-1.62, 0.52, -0.35>
	pigment { rgb <0.85, 0.87, 0.9> }
	finish { ambient 0 diffuse 0.25 specular 0.8 roughness 0.01 metallic reflection { 0.6 metallic } }
}

// Marbles along a golden spiral.
#for (I, 1, Marbles)
	#declare Turn = I * 2.39996;
	#declare Place = vrotate((1.25 + 0.32 * sqrt(I)) * x, y * degrees(Turn)) + <0, 0.1, 0.1>;
	#declare Far = (vlength(Place - <1.75, 0.1, -0.55>) > 0.8 & vlength(Place - <-1.62, 0.1, -0.35>) > 0.75);
	#if (Far & Place.z < 2.2 & Place.z > -2.4)
		sphere { Place, 0.1
			pigment { rgbf <0.55 + 0.45 * sin(Turn), 0.55 + 0.45 * sin(Turn + 2.1), 0.55 + 0.45 * sin(Turn + 4.2), 0.55> }
			finish { ambient 0.05 diffuse 0.5 specular 0.9 roughness 0.003 reflection { 0.02, 0.6 falloff 3 } }
			interior { ior 1.4 }
		}
	#end
#end
