// waits for: mesh2
// Form of Blender's exporter, its bodies: mesh2 with uv vectors and a texture list, moved by a matrix.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background {rgbt<0.1, 0.1, 0.12, 0>}
camera { location <0, 0, 0> look_at <0, 0, -1> right <-1.333333, 0, 0> up <0, 1, 0> angle 40.0 translate <0.0, 0.3, 5.0> }
light_source { < 0,0,0 > color srgb<1, 1, 1> matrix <1,0,0, 0,1,0, 0,0,1, 2.0,4.0,3.0> }
#declare DATA_body =
mesh2 {
    vertex_vectors {
        4
        ,<-1.000000,-1.000000,0.000000>
        ,<1.000000,-1.000000,0.200000>
        ,<1.000000,1.000000,0.000000>
        ,<-1.000000,1.000000,-0.200000>
    }
    uv_vectors {
        4, <0,0>, <1,0>, <1,1>, <0,1>
    }
    texture_list {
        2
        ,texture {pigment {srgb<0.8, 0.3, 0.1>} finish {diffuse 0.8}}
        ,texture {pigment {srgb<0.1, 0.3, 0.8>} finish {diffuse 0.8}}
    }
    face_indices {
        2
        ,<0,1,2>, 0
        ,<0,2,3>, 1
    }
}
object { DATA_body matrix <0.9,0,0.2, 0,1,0, -0.2,0,0.9, 0.1,0.2,0> }
