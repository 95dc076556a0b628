// internal(59): the H and lacunarity of the first call hold for all calls of one declaration.
#declare F = function { internal(59) }
#declare G = F;
#declare Again = function { internal(59) }
#declare Call = function(x, y, z, H, L) { F(x, y, z, H, L, 5, 0.8, 1.1, 2) }
#declare Row = array[2] { function { internal(59) }, F }
#macro Say(Name, V) #debug concat(Name, " ", str(V, 0, 10), "\n") #end
Say("first", F(0.3, 0.4, 0.5, 0.9, 2, 5, 0.8, 1.1, 2))
Say("later", F(0.3, 0.4, 0.5, 0.1, 3.1, 5, 0.8, 1.1, 2))
Say("copy", G(0.3, 0.4, 0.5, 0.1, 3.1, 5, 0.8, 1.1, 2))
Say("caller", Call(0.3, 0.4, 0.5, 0.1, 3.1))
Say("array", Row[1](0.3, 0.4, 0.5, 0.1, 3.1, 5, 0.8, 1.1, 2))
Say("fewer octaves", F(0.3, 0.4, 0.5, 0.1, 3.1, 3, 0.8, 1.1, 2))
Say("other declaration", Again(0.3, 0.4, 0.5, 0.1, 3.1, 5, 0.8, 1.1, 2))
Say("and later", Again(0.3, 0.4, 0.5, 0.9, 2, 5, 0.8, 1.1, 2))
Say("in an array", Row[0](0.3, 0.4, 0.5, 0.4, 2.5, 5, 0.8, 1.1, 2))
Say("and later", Row[0](0.3, 0.4, 0.5, 0.9, 2, 5, 0.8, 1.1, 2))
// another noise generator does not empty the tables
global_settings { noise_generator 1 }
Say("other noise", F(0.3, 0.4, 0.5, 0.1, 3.1, 5, 0.8, 1.1, 0))
