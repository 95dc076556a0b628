// waits for: mesh
// Form of LeoCAD: everything behind #ifndef and #declare, a light macro of sixteen arguments, srgbf, two finishes in a
// texture, `angle` after look_at times the aspect ratio, parts as meshes of triangles and smooth triangles.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#ifndef (lc_reflection) #declare lc_reflection = 0.08; #end
#ifndef (lc_ambient) #declare lc_ambient = 0.4; #end
#ifndef (lc_diffuse) #declare lc_diffuse = 0.4; #end
#ifndef (lc_phong) #declare lc_phong = 0.5; #end
#ifndef (lc_phong_size) #declare lc_phong_size = 40; #end
#ifndef (lc_trans_filter) #declare lc_trans_filter = 0.85; #end
#ifndef (lc_background) #declare lc_background = srgb <0.2, 0.25, 0.3>; #end
background { color lc_background }
#macro lc_light(Type, Place, Target, Colour, Power, FadeDistance, FadePower, Radius, Falloff, Tight, AxisX, AxisY, Rows, Columns, Shadowless, Circular)
light_source {
 Place
 color Colour * Power
 #if (Type = 1) spotlight radius Radius falloff Falloff tightness Tight point_at Target #end
 #if (Type = 2) parallel point_at Target #end
 #if (Type = 3) area_light AxisX, AxisY, Rows, Columns #if (Circular) circular orient #end #end
 #if (FadeDistance > 0) fade_distance FadeDistance fade_power FadePower #end
 #if (Shadowless) shadowless #end
}
#end
lc_light(0, <4, -6, 8>, <0, 0, 0>, srgb <1, 1, 1>, 0.8, 0, 0, 0, 0, 0, x, y, 1, 1, 0, 0)
lc_light(1, <-4, -3, 6>, <0, 0, 0.5>, srgb <0.9, 0.8, 0.7>, 0.6, 12, 2, 20, 30, 1, x, y, 1, 1, 1, 0)
lc_light(3, <1, -8, 5>, <0, 0, 0>, srgb <1, 1, 1>, 0.3, 0, 0, 0, 0, 0, <1, 0, 0>, <0, 0, 1>, 3, 3, 0, 0)
#ifndef (lc_color_red)
#declare lc_color_red = texture {
 pigment { srgbf <0.79, 0.1, 0.04, 0> }
 finish { ambient lc_ambient diffuse lc_diffuse }
 finish { phong lc_phong phong_size lc_phong_size reflection lc_reflection }
}
#end
#ifndef (lc_color_clear)
#declare lc_color_clear = texture {
 pigment { srgbf <0.6, 0.8, 0.9, lc_trans_filter> }
 finish { ambient lc_ambient diffuse lc_diffuse }
 finish { phong lc_phong phong_size lc_phong_size reflection lc_reflection }
}
#end
camera {
 perspective
 right x * image_width / image_height
 sky <0, 0, 1>
 location <3, -6, 3>
 look_at <0, 0, 0.4>
 angle 26 * image_width / image_height
}
plane { z, 0 pigment { srgb <0.5, 0.5, 0.45> } }
#declare lc_part = mesh {
 triangle { <-1, -0.5, 0>, <1, -0.5, 0>, <1, -0.5, 0.8> }
 triangle { <-1, -0.5, 0>, <1, -0.5, 0.8>, <-1, -0.5, 0.8> }
 smooth_triangle { <-1, -0.5, 0.8>, <0, -0.3, 1>, <1, -0.5, 0.8>, <0, -0.3, 1>, <0, 0.5, 1.1>, <0, 0.3, 1> }
}
object { lc_part texture { lc_color_red } }
