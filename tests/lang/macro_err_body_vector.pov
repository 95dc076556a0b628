// A value of a macro that does not fit.
#version 3.7;
#macro Centre() <1, 2, 3> #end
sphere { 0, Centre() }
