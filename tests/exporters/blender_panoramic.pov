// waits for: panoramic
// Form of Blender's exporter, its panoramic camera.
#version 3.7;
global_settings { assumed_gamma 1.0 }
background {rgbt<0.2, 0.2, 0.25, 0>}
camera { panoramic location <0, 0, 0> look_at <0, 0, -1> right <-1.333333, 0, 0> up <0, 1, 0> angle 110.0 translate <0.5, 0.8, 4.0> }
light_source { < 0,0,0 > color srgb<1, 1, 1> matrix <1,0,0, 0,1,0, 0,0,1, 2.0,4.0,3.0> }
sphere { 0,1 pigment {srgb<0.3, 0.6, 0.2>} matrix <1,0,0, 0,1,0, 0,0,1, -0.3,0.4,0> }
torus { 1.4, 0.2 pigment {srgb<0.8, 0.6, 0.2>} matrix <1,0,0, 0,0.9,0.4, 0,-0.4,0.9, 0,0,0> }
