// The debug stream shows whole lines; what is incomplete at the end is lost.
#version 3.7;
#debug "a" #debug "b" #debug "c\nd" #debug "\n" #debug "lost"
