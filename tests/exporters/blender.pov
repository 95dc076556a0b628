// Form of Blender's exporter: a camera in the origin that looks along -z with a mirrored up and is rotated, then moved;
// rgbt background and sky, lights in the origin with a matrix, area_illumination, `tightness 0`, srgb, reflection with all
// its items. The area light has no `jitter` here: its random places are each program's own.
#version 3.7;
global_settings {
    assumed_gamma 1.0
    max_trace_level 5
}
#declare Default_texture = texture{pigment {srgb 0.8} finish {emission 0}}
background {rgbt<0.05, 0.05, 0.06, 0>}
sky_sphere {
    pigment {
        gradient y
        color_map {
            [0.0 rgbt<0.05, 0.05, 0.06, 0>]
            [1.0 rgbt<0.3, 0.4, 0.7, 0>]
        }
    }
}
#declare camLocation  = <0, 1.2, 6.0>;
#declare camLookAt    = <0, 0, -1>;
camera {
    location  <0, 0, 0>
    look_at  <0, 0, -1>
    right <-1.333333, 0, 0>
    up <0, 1, 0>
    angle  38.0
    rotate  <-10.0, 5.0, 0.0>
    translate <0.4, 1.3, 6.0>
}
light_source {
    < 0,0,0 >
    color srgb<0.9, 0.85, 0.8>
    fade_distance 9.0
    fade_power 2
    area_light <1.2,0,0>,<0,0,1.2> 3, 3
    area_illumination
    adaptive 1
    circular
    orient
    matrix <1,0,0, 0,1,0, 0,0,1, 2.0,4.0,3.0>
}
light_source {
    < 0,0,0 >
    color srgb<0.5, 0.5, 0.6>
    spotlight
    falloff 30.0
    radius 20.0
    tightness 0
    point_at <0, 0, -1>
    matrix <1,0,0, 0,0.8,-0.6, 0,0.6,0.8, -1.0,3.5,4.0>
}
#declare shader_ball = finish {
    specular 0.6 roughness 0.02
    diffuse 0.7 0.0
    ambient 0
    emission 0
    reflection {rgb<0.05, 0.05, 0.05>, rgb<0.4, 0.4, 0.4> fresnel 1 exponent 1.5 metallic 0.2}
    conserve_energy
}
sphere {
    0,1
    pigment {srgb<0.7, 0.2, 0.15>}
    finish {shader_ball}
    interior {ior 1.5}
    matrix <0.8,0,0, 0,0.8,0, 0,0,0.8, -0.6,0.8,0>
}
box {
    <-1,-1,-1>, <1,1,1>
    texture {Default_texture}
    matrix <0.5,0,0.3, 0,0.6,0, -0.3,0,0.5, 1.0,0.6,-0.4>
}
plane {
    <0,1,0>, 0
    pigment {checker srgb<0.4, 0.4, 0.4>, srgb<0.6, 0.6, 0.55>}
}
