// Strings cannot be added: there is concat.
#version 3.7;
#declare S = concat("a" + "b");
