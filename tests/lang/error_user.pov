#version 3.7;
#error "my own words\n"
