// The global settings that are not blocks.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 1 adc_bailout 0.01 max_trace_level 9 charset utf8 noise_generator 2
	number_of_waves 8 irid_wavelength rgb <0.7, 0.5, 0.4> mm_per_unit 20 }
#debug "ok\n"
