// Transforms declared, inverted, made functions of.
#declare T = transform { rotate x*30 translate y }
sphere { 0,1 transform T } sphere { 0,1 transform { T inverse } } sphere { 0,1 transform { transform T scale 2 } }
#declare V = function { transform { T } } #debug concat(vstr(3,V(1,0,0),",",0,3),"\n")
#include "transforms.inc"
#debug concat(vstr(3,vtransform(x, T),",",0,3), vstr(3,vinv_transform(x,T),",",0,3),"\n")
