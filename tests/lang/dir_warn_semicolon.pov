// From version 3.1 to 3.4 a missing semicolon is warned about.
#version 3.1;
#declare A = 5
#error "end of the case"
