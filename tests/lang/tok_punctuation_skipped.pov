// Characters without a meaning are harmless in skipped text.
#version 3.7;
#if (0) @ $ % ^ ~ \ ' ` # # ? ! #end
#debug "passed\n"
