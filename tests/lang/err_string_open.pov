#version 3.7;
#debug "never closed
