// An include file may be part of a statement.
#version 3.7;
#declare O = box { #include "dir_include_part.inc" }
#debug concat(vstr(3, max_extent(O), ",", 0, 0), "\n")
