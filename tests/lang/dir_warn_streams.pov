// #render and #statistics are #debug, with a warning.
#version 3.7;
#render "text\n"
#statistics "text\n"
#error "end of the case"
