// Signs and zeros that a finish does not expect: negative parts do nothing, but for a negative ambient, which darkens; roughness 0 puts the highlight everywhere.
#version 3.7; global_settings { assumed_gamma 1 } camera { orthographic location -9*z look_at 0 right 8*x up 6*y } light_source{<4,6,-9> 1} light_source{<-6,2,-9> rgb <.3,.2,.1>}
#default{pigment{rgb <.9,.7,.5>} finish{ambient .2}}
#macro S(X,Y,F) sphere{<X,Y,0>,.6 pigment { rgb <.9,.7,.5> } finish{F}} #end
sphere{<-3,2,0>,.6 finish{diffuse -.5}}
sphere{<-1.5,2,0>,.6 finish{phong -.5}}
sphere{<0,2,0>,.6 finish{specular -.5}}
sphere{<1.5,2,0>,.6 finish{reflection -.5}}
sphere{<3,2,0>,.6 finish{ambient -.5}}
sphere{<-3,.5,0>,.6 finish{specular .4 roughness 0}}
sphere{<-1.5,.5,0>,.6 finish{reflection {.5} reflection_exponent 2}}
sphere{<0,.5,0>,.6 finish{phong .5 phong_size 0}}
sphere{<1.5,.5,0>,.6 finish{brilliance 0}}
sphere{<3,.5,0>,.6 finish{brilliance -1}}
sphere{<-3,-1,0>,.6 finish{emission -.5}}
sphere{<-1.5,-1,0>,.6 finish{diffuse .3,-.5}}
sphere{<0,-1,0>,.6 finish{metallic -1 specular .5}}
sphere{<1.5,-1,0>,.6 finish{reflection{-.2,.5}}}
sphere{<3,-1,0>,.6 finish{crand 0 diffuse 0 specular .4 roughness 0}}
sky_sphere{pigment{gradient y color_map{[0 rgb .2][1 rgb <.2,.4,1>]}}}
