// A literal may run over line ends; they are part of it.
#version 3.7;
#debug "one
two

four\n"
