// input_file_name is the scene's name without its folder.
#version 3.7;
#debug concat(input_file_name, "\n")
