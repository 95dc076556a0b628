// Scenes choose by version.
#version 3.7;
#if (version >= 3.7) #debug "new\n" #else #debug "old\n" #end
