// Keys and values may come from macros, loops and conditions.
#version 3.7;
#macro Pt(I) <I, I*I, -I> #end
#declare S = spline { natural_spline #for (I, 0, 4) I, Pt(I) #end }
#debug concat(vstr(3, S(2.5), " ", 0, 6), "\n")
