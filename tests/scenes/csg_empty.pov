// What is empty takes nothing away and leaves everything: seven spheres, the last with a dent.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,0,-9> look_at 0 }
light_source { <2,4,-5> rgb 1 }
background { rgb <0, 0.5, 1> }
#default { pigment { rgb <1,1,0> } }
difference { sphere { <-4, 1.5, 0>, 1 } union { } }
difference { sphere { <-1.5, 1.5, 0>, 1 } union { light_source { <2,4,-5> rgb 0.2 } } }
difference { sphere { <1.5, 1.5, 0>, 1 } merge { } }
intersection { sphere { <4, 1.5, 0>, 1 } union { inverse } }
intersection { sphere { <-4, -1.5, 0>, 1 } intersection { } }
sphere { <-1.5, -1.5, 0>, 1 clipped_by { union { inverse } } }
difference { sphere { <1.5, -1.5, 0>, 1 } union { union { } union { sphere { <1.5, -1.5, -1>, 0.5 } } } }
