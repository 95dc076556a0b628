// Bytes above 127 are ignored in comments: äÿ
#version 3.7;
/* Ã¤ € */
#debug "passed\n"
