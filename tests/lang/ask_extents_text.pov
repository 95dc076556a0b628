// A blank is a point at the place of the pen: it counts in the extents, at both ends of a text, too.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Tell(O)
	#local Nudge = 0.0001;
	#debug concat(vstr(3, min_extent(O) + Nudge, " ", 0, 3), " | ", vstr(3, max_extent(O) + Nudge, " ", 0, 3), "\n")
#end
#macro AskText(Font, String, Offset)
	#local Text = text { ttf Font String 0.5, Offset }
	Tell(Text)
#end
#macro AskAll(Font, Offset)
	AskText(Font, "A", Offset)
	AskText(Font, "A    ", Offset)
	AskText(Font, "   A", Offset)
	AskText(Font, "    ", Offset)
	AskText(Font, " ", Offset)
	AskText(Font, "Hi     ", Offset)
	AskText(Font, "f  ", Offset)
	AskText(Font, " y ", Offset)
	AskText(Font, "a b", Offset)
	AskText(Font, "  a b  ", Offset)
#end
AskAll("timrom.ttf", 0)
AskAll("cyrvetic.ttf", 0)
AskAll("timrom.ttf", <0.1,0.2,0.3>)
AskAll("timrom.ttf", <-0.5,-0.2,0.3>)
Tell(text { ttf "timrom.ttf" "  " 1, 0 rotate 30*y translate <1,2,3> })
Tell(text { ttf "timrom.ttf" "A  " 1, 0 rotate 30*y translate <1,2,3> })
Tell(text { ttf "timrom.ttf" "  A " 1, 0 scale 2 inverse rotate 30*z translate <1,2,3> })
#include "shapes.inc"
Tell(Center_Object(text { ttf "timrom.ttf" "Hi     " 1, 0 }, x))
