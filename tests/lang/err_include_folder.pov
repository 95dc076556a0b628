// A folder is no include file.
#version 3.7;
#include "/"
