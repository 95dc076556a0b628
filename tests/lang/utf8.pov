#version 3.7;
#debug concat(str(strlen("ä€😀"),0,0)," ",str(asc("ä"),0,0)," ",str(asc("😀"),0,0),"\n")
#debug "two
lines\n"
#debug concat(str(strlen("a
b"),0,0),"\n")
// comment �#debug concat("[",substr("äxyz",2,2),"]\n")