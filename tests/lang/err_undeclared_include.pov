// Names that an include file of the search path declares; not one that is only in a comment or a
// string there, or that the file keeps to itself.
#version 3.7;
#declare Include_Comments = 1;
#declare Include_Strings = 2;
#declare Include_Locals = 3;
sphere { 0, Include_Only }
sphere { 0, Include_Macro(1) }
sphere { 0, Include_Deprecated }
sphere { 0, Include_Comment }
sphere { 0, Include_String }
sphere { 0, Include_Local }
