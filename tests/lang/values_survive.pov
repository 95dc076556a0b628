// Strings and arrays that nobody holds any more are given back now and then; those that somebody
// holds stay what they are: in variables, arrays, arrays of arrays, parameters, behind #undef.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Name = concat("na", "me");
#declare Table = array[3];
#declare Table[1] = concat("one", " of three");
#declare Nest = array[2] { array[2] { "a", "b" }, array[2] { "c", "d" } }
#declare Gone = "gone";
#macro Keep(Text, List)
	#local Mine = array[2] { concat(Text, "!"), List[1] }
	#local I = 0;
	#while (I < 3)
		#local Mine[0] = concat(Mine[0], str(I, 0, 0));
		#local I = I + 1;
	#end
	concat(Mine[0], Mine[1])
#end
#declare Last = "";
#declare I = 0;
#while (I < 60000)
	#declare Row = array[4] { I, I + 1, I + 2, I + 3 }
	#declare Copy = Row;
	#declare Copy[0] = Row[3] - Copy[0];
	#declare Last = concat(Last, chr(65 + mod(I, 26)));
	#declare Short = substr(concat("<", str(I, 0, 0), ">", Name), 1, 3);
	#if (mod(I, 500) = 0)
		#declare Last = Keep(Short, Nest[1]);
		#declare Nest[0][1] = concat(Short, Nest[1][0]);
		#declare Table[2] = Last;
		#undef Gone
		#declare Gone = concat("once ", Short);
	#end
	#declare I = I + 1;
#end
#debug concat(Name, "|", Table[1], "|", Table[2], "\n")
#debug concat(Nest[0][0], Nest[0][1], Nest[1][1], "|", Gone, "|", Short, "\n")
#debug concat(substr(Last, 1, 60), "|", str(strlen(Last), 0, 0), "\n")
#debug concat(str(Row[2] + Copy[0] + Copy[1], 0, 0), "\n")
sphere { 0, 1 }
