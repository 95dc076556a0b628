// The predefined identifiers may be declared anew, in another type too.
#version 3.7;
#declare image_width = 5;
#declare frame_number = "five";
#debug concat(str(image_width, 0, 0), " ", frame_number, "\n")
