// vnormalize of a zero vector is warned about.
#version 3.7;
#declare A = vnormalize(<0, 0, 0>);
#error "end of the case"
