// Shapes of splines: lathe, prism, sor, sphere_sweep.
#version 3.7;
#declare A = lathe { linear_spline 3, <0, 0>, <1, 1>, <0, 2> }
#declare A = lathe { quadratic_spline 4 <0, 0> <1, 1> <1, 2> <0, 3> sturm }
#declare A = lathe { cubic_spline 5, <0, 0>, <1, 1>, <1, 2>, <0.5, 3>, <0, 4> }
#declare A = lathe { bezier_spline 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
#declare A = prism { linear_spline linear_sweep 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> }
#declare A = prism { linear_sweep bezier_spline 0 1 4 <0, 0> <1, 0> <1, 1> <0, 0> open }
#declare A = prism { conic_sweep linear_spline 1, 0, 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> }
#declare A = sor { 5, <0, -1>, <1, 0>, <1.5, 1>, <1, 2>, <0, 3> open }
#declare A = sphere_sweep { linear_spline 2, 0, 1, x, 0.5 tolerance 0.01 }
#declare A = sphere_sweep { cubic_spline, 4, -x, 1, 0, 1, x, 1, 2*x, 1 }
#declare A = sphere_sweep { b_spline 4, -x 1 0 1 x 1 2*x 1 }
#debug "ok\n"
