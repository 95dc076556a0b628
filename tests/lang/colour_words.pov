// Components given one by one, in any order and without commas; the rest is 0.
#version 3.7;
#declare C = color red 0.5 blue 0.25 transmit 0.125;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = colour green 1 filter 0.5 green 0.75;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
