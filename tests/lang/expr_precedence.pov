// Sign, product, sum, relation, logic, from the tightest on; all from left to right.
#version 3.7;
#macro Show(X) #debug concat(str(X, 0, 4), "\n") #end
Show(2 + 3*4) Show(2*3 + 4) Show(10 - 3 - 2) Show(16/4/2) Show(16/4*2) Show(-2*-3) Show(2 - -3)
Show((1 + 1 < 3)) Show((1 < 2 = 1)) Show((0 = 1 < 2))
