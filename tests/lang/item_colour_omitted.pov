// The items whose colour may be left out, which is black then.
#version 3.7;
global_settings { ambient_light irid_wavelength assumed_gamma 1 }
#declare F = finish { reflection phong 1 subsurface { translucency } }
#declare F = finish { reflection { } }
#declare F = finish { reflection { , } }
#declare F = finish { reflection { , 1 } }
#declare F = finish { reflection { fresnel } }
#declare F = finish { reflection { metallic falloff 2 } }
#declare F = finish { reflection { 1, 1 exponent 2 } }
#declare P = pigment { rgb 1 quick_color }
#declare I = interior { ior 1.5 fade_color }
sphere { 0, 1 }
#debug "read\n"
