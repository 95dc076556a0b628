// A number that names no stream.
#version 3.7;
#declare A = seed(1);
#declare B = rand(5);
