#version 3.7;
#break
