// radius belongs to a spotlight or a cylinder.
#version 3.7;
light_source { 9*y, rgb 1 radius 10 }
