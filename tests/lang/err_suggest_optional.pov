// The nearest word is found behind a number that another may follow, too.
#version 3.7;
sphere { 0, 1 finish { diffuse 0.2 speculr 0.8 } }
