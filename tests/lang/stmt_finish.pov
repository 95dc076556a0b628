// The items of a finish.
#version 3.7;
#declare A = finish { ambient 0.1 diffuse 0.6 brilliance 2 crand 0.1 phong 0.5 phong_size 40 }
#declare A = finish { A specular 0.5 roughness 0.01 metallic reflection 0.5 reflection_exponent 1 conserve_energy }
#declare A = finish { emission rgb x diffuse albedo 0.5, 0.2 specular albedo 0.5 phong albedo 0.2 metallic 0.5 }
#declare A = finish { reflection { 0.1, 0.9 fresnel on falloff 2 exponent 1 metallic 1 } }
#declare A = finish { irid { 0.3 thickness 0.5 turbulence 0.2 } }
#debug "ok\n"
