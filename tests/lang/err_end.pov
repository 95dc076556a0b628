#version 3.7;
#end
