// Photons would be shot at the target. lambert only
#version 3.7;
global_settings { photons { spacing 0.1 gather 20, 100 radius 1, 1 autostop 0 jitter 0.3 expand_thresholds 0.1, 30
	max_trace_level 8 adc_bailout 0.1 media 10, 1 } assumed_gamma 1 }
light_source { <5, 5, -5>, 1 photons { reflection on refraction on } }
#declare Lens = sphere { 0, 1 photons { target reflection on refraction on } }
union { object { Lens } box { 1, 2 } }
