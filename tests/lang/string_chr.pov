// chr makes one character of a code; chr(0) is the empty string.
#version 3.7;
#debug concat(chr(72), chr(105.9), chr(33), str(strlen(chr(0)), 0, 0), str(strlen(chr(65535)), 0, 0), "\n")
