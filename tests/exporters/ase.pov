// switches: ase.ini -P
// Form of ASE, with its INI file: a camera with right, up and direction by factors of the axes before its location, a texture macro,
// `color COL transmit T`. The area light has no `jitter` here: its random places are each program's own.
#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 1 max_trace_level 6}
background {color White transmit 1.0}
camera {orthographic
  right -9.60*x up 7.20*y
  direction 1.00*z
  location <0,0,20.00> look_at <0,0,0>}
light_source {<2.00, 3.00, 25.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 3, 3
  adaptive 1}

#declare simple = finish {phong 0.7}
#declare pale = finish {ambient .5 diffuse .85 roughness .001 specular 0.200 }
#declare jmol = finish {ambient .2 diffuse .6 specular 1 roughness .001 metallic}
#declare Rcell = 0.050;
#declare Rbond = 0.100;

#macro atom(LOC, R, COL, TRANS, FIN)
  sphere{LOC, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union{torus{R, Rcell rotate 45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
      torus{R, Rcell rotate -45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
      translate LOC}
#end

cylinder {< -3.40,  -2.60,  -1.00>, <  3.40,  -2.60,  -1.00>, Rcell pigment {Black}}
cylinder {< -3.40,  -2.60,  -1.00>, < -3.40,   2.60,  -1.00>, Rcell pigment {Black}}
cylinder {<  3.40,   2.60,  -1.00>, <  3.40,  -2.60,  -1.00>, Rcell pigment {Black}}
atom(< -1.50,  -0.60,  -1.20>, 1.20, color rgb <0.80, 0.50, 0.25>, 0.0, simple) // #0
atom(<  0.90,  -0.30,   0.40>, 1.10, color rgb <0.90, 0.10, 0.15>, 0.0, pale) // #1
atom(<  1.40,   1.40,  -0.60>, 0.80, color rgb <0.40, 0.55, 0.90>, 0.3, jmol) // #2
cylinder {< -1.50,  -0.60,  -1.20>, < -0.30,  -0.45,  -0.40>, Rbond texture{pigment {color rgb <0.80, 0.50, 0.25> transmit 0.0} finish{simple}}}
constrain(< -1.50,  1.70,  0.20>, 0.60, color rgb <0.10, 0.70, 0.30>, 0.0, simple)
