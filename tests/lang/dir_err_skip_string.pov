// Strings must be closed in skipped text, too.
#version 3.7;
#if (0) "not closed
#end
