// #elseif without #if.
#version 3.7;
#elseif (1)
