// rand needs a stream that seed has made.
#version 3.7;
#declare A = rand(0);
