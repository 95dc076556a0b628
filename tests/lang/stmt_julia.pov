// julia_fractal with functions and slices.
#version 3.7;
#declare J = julia_fractal { <-0.2, 0.4, -0.4, -0.4> max_iteration 8 precision 15 slice <0, 0, 0, 1>, 0 }
#declare K = julia_fractal { <-0.2, 0.4, 0, 0> hypercomplex sin }
#declare L = julia_fractal { <-0.2, 0.4, 0, 0> hypercomplex pwr(3, 0) }
#declare M = julia_fractal { <-0.2, 0.4, 0, 0> quaternion cube }
#debug "ok\n"
