// file_exists looks where an include file would be looked for.
#version 3.7;
#debug concat(str(file_exists("colors.inc"), 0, 0), str(file_exists("no such file.inc"), 0, 0), "\n")
