// Comments nest; "//" and quotes mean nothing inside.
#version 3.7;
/* a /* b */ // " c */
#debug "one\n" // /* not opened
#debug "two\n"
/**/ #debug "three\n" /***/
/*/ still open */
#debug "four\n"
#debug "/* text */ // text\n"
