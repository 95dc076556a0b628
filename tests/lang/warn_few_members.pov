// A compound of fewer than two members is most often a brace in the wrong place; lights are members.
#version 3.7;
global_settings { assumed_gamma 1 }
union { sphere { 0, 1 } light_source { y, 1 } }
#declare Two = union { sphere { 0, 1 } box { 0, 1 } }
union { Two translate x }
difference { sphere { 0, 1 } }
#declare One = merge { box { 0, 1 } }
object { One }
intersection { }
