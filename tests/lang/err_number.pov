#version 3.7;
#if (0)
 1.2.3
#end
