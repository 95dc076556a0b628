// Where the end of a faulty statement is not certain nothing more is said.
#version 3.7;
sphere { 0, 1 pigment { rgb 1 }
box { 0, Foo }
sphere { 0, Bar }
