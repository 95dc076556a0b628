// #elseif is evaluated behind a branch not taken only, and may follow #ifdef.
#version 3.7;
#if (0) #debug "a\n" #elseif (0) #debug "b\n" #elseif (1) #debug "c\n" #elseif (undeclared) #debug
	"d\n" #else #debug "e\n" #end
#ifdef (Nothing) #debug "a\n" #elseif (1) #debug "b\n" #end
#ifndef (Nothing) #debug "a\n" #elseif (undeclared) #debug "b\n" #end
#if (0) #elseif (0) #else #debug "else\n" #end
