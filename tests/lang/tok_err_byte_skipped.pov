// A byte above 127 is illegal in text that a false #if skips, too.
#version 3.7;
#if (0)
  a ä b
#end
