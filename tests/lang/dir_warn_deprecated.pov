// A deprecated identifier warns at each use, or only once, with its message.
#version 3.7;
#declare deprecated A = 1;
#declare deprecated once "use New instead of Old" Old = 2;
#declare B = A + A;
#declare B = Old + Old;
#error "end of the case"
