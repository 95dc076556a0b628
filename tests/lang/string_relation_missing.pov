// A string before anything but a comparison.
#version 3.7;
#if ("a") #debug "yes\n" #end
