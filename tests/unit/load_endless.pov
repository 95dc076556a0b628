// Is never read to its end: test_load.c stops it.
#version 3.7;
#while (true)
#end
