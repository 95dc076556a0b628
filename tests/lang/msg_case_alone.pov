// #case outside of a #switch.
#version 3.7;
#case (1)
