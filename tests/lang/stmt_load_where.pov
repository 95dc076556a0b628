// A setting that belongs in global_settings.
#version 3.7;
camera { location -z }
assumed_gamma 1
