// isosurface and its items, with each container.
#version 3.7;
#declare I = isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -1.1, 1.1 } } threshold 0 accuracy 0.01
	max_gradient 4 max_trace 2 open }
#declare I = isosurface { function { sqrt(x*x + y*y) - 0.5 } contained_by { sphere { 0, 2 } } evaluate 1, 1.2, 0.9
	all_intersections }
#declare I = isosurface { function { y } }
#debug "ok\n"
