#version 3.7;
#declare deprecated once "Old is old" Old = 3;
#declare A = Old + Old;
#debug concat(str(A, 0, 0), "\n")
declare B = 4;
#debug concat(str(B, 0, 0), "\n")
#declare C = color rgb 1;;
#undef NotThere
#macro Outer(A) #local B = A + 1; #include "includes_sub.inc" #debug concat(str(C, 0, 0), str(B, 0, 0), "\n") #end
Outer(1)
#debug concat(str(FromSub, 0, 0), " ", str(defined(SubLocal), 0, 0), "\n")
Sub(5)
#if (Start = 1) #debug "taken\n"
#include "includes_close.inc"
#debug concat(str(rand(seed(5)), 0, 8), " ", str((now > 9000), 0, 0), " ", str(clock + clock_on, 0, 0), "\n")
#include "includes_open.inc" wrong #else #debug "else of an include\n" #end
#include "includes_open.inc" #if (1) #else #end wrong #end #debug "behind\n"
