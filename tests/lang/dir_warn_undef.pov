// #undef of an unknown name is a warning.
#version 3.7;
#undef NotThere
#error "end of the case"
