#version 3.7;
#if (1)
#while (0)
#end
sphere { 0, 1 }
