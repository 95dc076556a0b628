// #warning prints its text and goes on.
#version 3.7;
#warning "first\n"
#warning concat("sec", "ond")
#error "end of the case"
