// #case without #switch.
#version 3.7;
#case (1)
