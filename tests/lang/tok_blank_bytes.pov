// Space, tab, vertical tab, form feed and line ends are white space.
#version 3.7;
#debug 	
concat("a",str(1+	2, 0, 0), "\n")
