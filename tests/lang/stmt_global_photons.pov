// The settings of photons. lambert only
#version 3.7;
global_settings { photons { spacing 0.1 gather 20, 100 radius 1, 1 autostop 0 jitter 0.3 expand_thresholds 0.1, 30
	max_trace_level 8 adc_bailout 0.1 media 10, 1 } }
