// #case has a tolerance of 1e-10, #range is exact.
#version 3.7;
#macro M(V) #switch (V) #case (5) #debug "five " #break #range (6, 7) #debug "range " #break #else
	#debug "else " #end #end
M(5 + 5e-11) M(5 - 2e-10) M(6) M(7) M(7.00000000001) M(5.99999999999)
#debug "\n"
