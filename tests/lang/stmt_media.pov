// media and interior.
#version 3.7;
#declare M = media { scattering { 2, rgb 0.1 extinction 0.5 } absorption 0.1 emission rgb 0.2 intervals 2
	samples 3, 8 method 3 confidence 0.95 variance 0.01 ratio 0.8 jitter 0.5 aa_level 4 aa_threshold 0.1 }
#declare N = media { M scattering { 5, 0.1 eccentricity 0.2 } density { spherical density_map {
	[0 rgb 0] [1 rgb 1] } }
	density { rgb 2 } collect off scale 2 }
#declare I = interior { ior 1.5 dispersion 1.02 dispersion_samples 9 caustics 0.5 fade_color rgb x fade_distance 2
	fade_power 1 media { M } }
#debug "ok\n"
