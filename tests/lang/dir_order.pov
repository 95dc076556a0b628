// A value is fetched when its token is read: what a directive changes later does not count.
#version 3.7;
#macro Show(X) #debug concat(vstr(3, X, ",", 0, 0), "\n") #end
#declare R = 1;
#declare O = box { 0, R #declare R = 5; translate R*x }
Show(max_extent(O))
#declare A = R + #declare R = 7; R;
#debug concat(str(A, 0, 0), "\n")
