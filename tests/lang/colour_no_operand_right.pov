// Not after a plus either.
#version 3.7;
#declare D = rgb 1;
#declare C = D + rgb 1;
