// asin and acos of values beyond 1 are warned about.
#version 3.7;
#declare A = asin(2);
#declare A = acos(-2);
#error "end of the case"
