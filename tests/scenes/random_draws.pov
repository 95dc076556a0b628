// Grain and a jittered area light, so faint that another noise is within the tolerance; tests/scenes/determinism
// sees it.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
background { rgb <0.1, 0.2, 0.4> }
light_source { <-3, 5, -4> rgb 0.7 area_light x * 0.04, z * 0.04, 3, 3 jitter adaptive 1 }
light_source { <3, 5, -4> rgb 0.3 spotlight point_at 0 radius 20 falloff 30 area_light x * 0.04, z * 0.04, 4, 2 jitter area_illumination }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } finish { crand 0.008 reflection 0.2 } }
sphere { <-0.6, 0.7, 0>, 0.7 pigment { rgbt <1, 1, 1, 0.5> } finish { crand 0.008 phong 0.5 } interior { ior 1.3 } }
box { <0.5, 0, 0>, <1.2, 0.7, 0.7> texture { pigment { rgb 0.8 } } texture { pigment { bozo color_map { [0 rgbt 1] [1 rgb <1, 0, 0>] } } finish { crand 0.008 } } }
