// A directive word is not meant by what looks like it in a statement.
#version 3.7;
light_source { 0, color White }
