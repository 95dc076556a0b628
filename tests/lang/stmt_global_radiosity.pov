// The settings of radiosity. lambert only
#version 3.7;
global_settings { radiosity { count 50, 2000 error_bound 1 low_error_factor 0.5 nearest_count 8, 3 minimum_reuse 0.01
	maximum_reuse 0.1 recursion_limit 2 brightness 1 gray_threshold 0.5 pretrace_start 0.08 pretrace_end 0.02
	adc_bailout 0.02 max_sample 1 always_sample off normal on media off } }
