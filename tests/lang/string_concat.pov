// concat takes any number of strings, nested or alone, commas optional.
#version 3.7;
#declare S = "one";
#debug concat(concat(S), " ", concat("two" " ", "three"), "\n")
