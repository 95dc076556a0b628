// What has no value, outside of functions and within them.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(A) #debug concat(str(A, 0, 3), " ") #end
Show(0/0) Show(-1/0) Show(1/0) Show(int(1e10)) Show(int(-1e10)) Show(pow(0, -1)) Show(div(1, 0))
#debug "\n"
#declare Ratio = function(x, y) { x/y }
#declare Whole = function(x) { int(x) }
#declare Power = function(x, y) { pow(x, y) }
#declare Angle = function(x, y) { atan2(x, y) }
Show(Ratio(-1, 0)) Show(Ratio(1, 0)) Show(Whole(1e10)) Show(Whole(-1e10)) Show(Power(0, 0)) Show(Power(0, -1)) Show(Angle(0, 0))
#debug "\n"
sphere { 0, 1 }
