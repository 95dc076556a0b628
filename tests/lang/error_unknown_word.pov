#version 3.7;
spere { 0, 1 }
