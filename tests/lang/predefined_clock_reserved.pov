// clock is a word of the language.
#version 3.7;
#declare clock = 5;
