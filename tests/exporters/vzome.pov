// Form of vZome: the place of the camera by an expression before look_at, `right` times -x, `orthographic` inside #if,
// assumed_gamma 2.2, a declared transform.
#include "colors.inc"
#declare parallel_view = 0;
#declare view_distance = 7;
#declare look_at_point = <0, 0.2, 0>;
#declare look_dir = <-0.3, -0.4, -1>;
#declare up_dir = <0, 1, 0>;
#declare aspect = image_width / image_height;
#declare anim = transform { rotate <0, 25, 0> }
camera {
 #if (parallel_view) orthographic #end
 location look_at_point - view_distance * look_dir / vlength(look_dir)
 up up_dir
 right aspect * vlength(up_dir) * -x
 angle 32
 sky up_dir
 look_at look_at_point
}
#default { texture { finish { phong 0.3 ambient 0.4 diffuse 0.6 } } }
global_settings { assumed_gamma 2.2 }
light_source { <20, 30, 40> rgb <0.7, 0.7, 0.65> }
light_source { <-30, 10, 20> rgb <0.3, 0.3, 0.35> }
background { color rgb <0.55, 0.7, 0.85> }
#declare ball = union { sphere { 0, 0.35 } scale 1.1 }
#declare strut = cylinder { 0, 1.6 * x, 0.12 }
union {
 object { ball texture { pigment { rgb <0.95, 0.95, 0.9> } } }
 object { ball texture { pigment { rgb <0.95, 0.95, 0.9> } } translate 1.6 * x }
 object { strut texture { pigment { rgb <0.1, 0.3, 0.8> } } }
 object { strut texture { pigment { rgb <0.9, 0.7, 0.1> } } rotate 60 * z }
 object { strut texture { pigment { rgb <0.8, 0.1, 0.2> } } rotate <0, -70, 20> }
 transform anim
}
