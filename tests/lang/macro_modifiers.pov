// A body may be a list of modifiers.
#version 3.7;
#macro Moves(S) scale S translate x #end
#declare O = box { 0, 1 Moves(2) }
#debug concat(vstr(3, max_extent(O), ",", 0, 0), "\n")
