// Control codes other than white space are illegal.
#version 3.7;
sphere { 0,1 }
