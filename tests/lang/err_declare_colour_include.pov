// A colour by name in a declaration, without the file that declares it.
#version 3.7;
#declare C = color Red;
