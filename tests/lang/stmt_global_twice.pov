// A switch counts as a whole number here; several blocks add up.
#version 3.7;
global_settings { max_trace_level 9 }
global_settings { assumed_gamma 1.0 }
#debug "ok\n"
