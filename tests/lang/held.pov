// What is executed when: directives between the tokens of expressions.
#version 3.7;
#macro Show(S, X) #debug concat(S, " ", str(X, 0, 4), "\n") #end
#declare R = 1;
sphere { 0, R #declare R = 5; translate R*x }
Show("R", R)
#declare A = 1 + #declare R = 3; R;
Show("A", A)
#declare T = texture { pigment { rgb 1 } }
#declare U = texture { T finish { ambient 0 } }
sphere { 0, 1 texture { U } }
#macro F(C) #if (C) 10 #else 20 #end #end
Show("in brackets", (F(1)))
Show("two", max(F(0), F(1)))
sphere { 0, F(1) }
#declare K = 2;
#declare V = <K #declare K = 3; , K, 1>;
Show("V.x", V.x) Show("V.y", V.y)
#declare B = (K > 2 ? 5 : 6);
Show("B", B)
#if ((K > 2) & (V.x < 3)) #debug "both\n" #end
#if (K > 2 | 0) #debug "either\n" #end
#if (<1,2,3>.y > 1) #debug "component\n" #end
#declare C = rgb <1, .5, 0> filter 0.25;
Show("C.filter", C.filter)
#declare Fn = function { x #for (I, 1, 3) + I #end };
Show("function", Fn(1, 0, 0))
