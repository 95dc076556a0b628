// The character @ has no meaning.
#version 3.7;
sphere { 0, 1 @ }
