// waits for: mesh_camera
// Form of Blender's exporter, its camera for baking: rays start on the faces of a mesh.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background {rgbt<0.2, 0.2, 0.25, 0>}
#declare Baked = mesh2 {
    vertex_vectors { 4 ,<-1.5,-1,2> ,<1.5,-1,2> ,<1.5,1,2> ,<-1.5,1,2> }
    uv_vectors { 4, <0,0>, <1,0>, <1,1>, <0,1> }
    face_indices { 2 ,<0,2,1> ,<0,3,2> }
}
camera { mesh_camera { 1 3 mesh { Baked } } location <0, 0, 0.01> direction <0, 0, -1> }
light_source { < 0,0,0 > color srgb<1, 1, 1> matrix <1,0,0, 0,1,0, 0,0,1, 2.0,4.0,3.0> }
sphere { 0,1 pigment {srgb<0.3, 0.6, 0.2>} matrix <1,0,0, 0,1,0, 0,0,1, -0.3,0.4,0> }
torus { 1.4, 0.2 pigment {srgb<0.8, 0.6, 0.2>} matrix <1,0,0, 0,0.9,0.4, 0,-0.4,0.9, 0,0,0> }
