// chr takes codes of 16 bits.
#version 3.7;
#declare S = chr(65536);
