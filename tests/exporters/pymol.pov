// waits for: mesh2
// Form of PyMOL: no #version, a camera in the origin with right and up, a default finish with `phong -1`, no comma before
// the radius of an open cylinder, and one mesh2 for each triangle.
camera {direction<0.0,0.0,-2.800> location <0.0 , 0.0 , 0.0> right 1.333*x up y }
#default { finish{phong -1.000 ambient 0.340 diffuse 0.450 phong_size 12.5}}
light_source{<4.0, 6.0, 2.0> rgb<1.0,1.0,1.0>}
plane{z , -11.0 pigment{color rgb<0.2,0.3,0.5>} finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
sphere{<-0.7,0.2,-8.0>, 0.8 pigment{color rgb<0.3,0.9,0.3>}}
cylinder{<0.0,-0.8,-8.0>, <1.4,0.6,-7.6> 0.25 open pigment{color rgb<0.9,0.3,0.3>}}
mesh2 { vertex_vectors { 3, <-1.6,-1.1,-8.2>, <0.6,-1.2,-8.0>, <-0.5,0.5,-7.0>}
 normal_vectors { 3, <-0.2,0.0,1.0>, <0.2,0.0,1.0>, <0.0,0.3,1.0>}
 texture_list { 3, texture { pigment{color rgb<1.0,0.0,0.0>} }, texture { pigment{color rgb<0.0,1.0,0.0>} },
 texture { pigment{color rgb<0.0,0.0,1.0>} } }
 face_indices { 1, <0,1,2>, 0, 1, 2} }
