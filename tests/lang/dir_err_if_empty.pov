// A condition cannot be empty.
#version 3.7;
#if () #end
