// What lies behind 120 000 clear surfaces is seen: no number of them ends a ray.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -z*2 look_at 0 up y right x } // only the middle one of 3 x 3 rays meets them
#declare Grain = sphere { 0, 0.004 pigment { rgbt 1 } }
union { #for (I, 1, 60000) object { Grain translate z*I/100 } #end }
plane { z, 700 pigment { rgb <1, 0.5, 0.25> } finish { ambient 1 diffuse 0 } }
