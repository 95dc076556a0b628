// Bytes that the charset does not have: said once for a string, at the first.
#version 3.7;
global_settings { assumed_gamma 1 }
#debug "grün weiß"
#declare Same = "�";
