// Each opening of a comment inside a comment needs a close of its own.
#version 3.7;
/* outer /* inner */
sphere { 0, 1 }
