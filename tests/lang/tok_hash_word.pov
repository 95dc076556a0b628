// # before a word that is no directive is ignored.
#version 3.7;
#sphere { 0, 1 #pigment { #rgb 1 } }
#debug "passed\n"
