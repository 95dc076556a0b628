// Light sources of all kinds and light groups.
#version 3.7;
light_source { <0, 9, 0>, rgb 1 } light_source { 9*y color red 1 shadowless }
light_source { 9*y rgb 1 spotlight point_at 0 radius 10 falloff 20 tightness 5 }
light_source { 9*y, 1 cylinder point_at x radius 1 falloff 2 tightness 0 parallel }
light_source { 9*y, rgb 1 parallel point_at y }
light_source { 9*y, rgb 1 area_light x, z, 3, 3 adaptive 1 jitter circular orient area_illumination on }
light_source { 9*y, rgb 1 fade_distance 5 fade_power 2 media_attenuation on media_interaction off }
light_source { 9*y, rgb 1 looks_like { sphere { 0, 1 } } translate x }
light_source { 9*y, rgb 1 photons { refraction on reflection off area_light } }
#declare L = light_source { 9*y, rgb 1 }
light_source { L translate x }
light_group { light_source { 9*y, rgb 1 } sphere { 0, 1 } global_lights off rotate 5*y }
#debug "ok\n"
