// Of the words for constants only pi and clock stand in a function.
#version 3.7;
#declare F = function(x) { pi + clock + true }
