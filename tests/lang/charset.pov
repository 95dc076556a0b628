#version 3.7;
#debug concat(str(strlen("äx"),0,0)," ",str(asc("ä"),0,0),"\n")
#version 3.1;
#debug concat(str(strlen("äx"),0,0)," ",str(asc("ä"),0,0),"\n")
#version 3.7;
global_settings { assumed_gamma 1 charset utf8 }
#debug concat(str(strlen("äx"),0,0)," ",str(asc("ä"),0,0),"\n")
#debug concat("[\u00e4]", str(asc("\u20ac"),0,0), "\n")
