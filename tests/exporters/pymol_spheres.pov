// Form of PyMOL without a surface: `phong -1` in the default finish draws no highlight.
camera {direction<0.0,0.0,-2.800> location <0.0 , 0.0 , 0.0> right 1.333*x up y }
#default { finish{phong -1.000 ambient 0.340 diffuse 0.450 phong_size 12.5}}
light_source{<4.0, 6.0, 2.0> rgb<1.0,1.0,1.0>}
plane{z , -11.0 pigment{color rgb<0.2,0.3,0.5>} finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
sphere{<-0.7,0.2,-8.0>, 0.8 pigment{color rgb<0.3,0.9,0.3>}}
cylinder{<0.0,-0.8,-8.0>, <1.4,0.6,-7.6> 0.25 open pigment{color rgb<0.9,0.3,0.3>}}
cylinder{<-1.2,-0.9,-8.0>, <0.4,-0.9,-7.6>, 0.15 pigment{color rgb<0.9,0.9,0.3>}}
