#version 3.7;
#include "err_include_self.pov"
