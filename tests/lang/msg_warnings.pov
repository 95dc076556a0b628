// What is warned of while the scene is read.
#version 3.7
global_settings { assumed_gamma 1 assumed_gamma 2 }
declare A = 1;
#declare B = rgb <1, 2, 3, 4>;
light_source { 0, rgbt 1 }
sphere { 0, 1 pigment { rgb 1 alpha 1 } finish { ior 1.5 } rgb 1 }
sphere { 0, 1 matrix < 1,0,0, 0,1,0, 0,0,0, 0,0,0 > }
#declare S = strupr("\u00E4");
#ifdef (5) #end
#error "end"
