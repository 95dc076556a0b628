// Expansion at token level, recursion, arguments of all kinds, values returned.
#version 3.7;
#macro Show(S, X) #debug concat(S, " ", str(X, 0, 4), "\n") #end
#macro Sum() 1+2 #end
Show("textual", Sum()*3)
Show("in brackets", (Sum())*3)
#macro List() 1, 5, 3 #end
Show("max of a list", max(List()))
#macro Fib(N) #if (N < 2) #local R = N; #else #local R = Fib(N-1) + Fib(N-2); #end R #end
Show("Fib(12)", Fib(12))
#macro Fact(N) #local R = 1; #if (N > 1) #local R = N * Fact(N-1); #end R #end
Show("Fact(20)", Fact(20))
#macro Define() #macro Made(X) X*X #end #end
Define()
Show("macro from a macro", Made(7))
#macro Made(X) X+1 #end
Show("redefined", Made(7))
#macro Commas(A B, C) A*100+B*10+C #end
Show("optional commas", (Commas(1 2, 3)))
Show("trailing comma", (Commas(1, 2, 3,)))
#macro Strings(S) concat("[", S, "]") #end
#debug concat(Strings("a"), Strings(concat("b", "c")), "\n")
#macro Early(N) #if (N > 3) #debug "early\n" #break #end #debug "late\n" #end
Early(5) Early(1)
#macro InLoop() #while (1) #debug "once\n" #break #end #debug "after\n" #end
InLoop()
#macro Vec(P) P.x #debug "side effect\n" #end
#declare V = <4, 5, 6>;
Show("vector", vlength(<Vec(V) V.y, 0>))
Show("directive in an argument", (#if (V.x > 3) 11 #else 12 #end))
#macro Depth(N) #if (N > 0) Depth(N - 1) #else #debug "bottom\n" #end #end
Depth(90)
#declare P = pigment { rgb 1 }
#macro Pig(Q) pigment { Q } #end
sphere { 0, 1 Pig(P) Pig(pigment { rgb x }) }
#declare F = function(x, y) { x + 2*y }
#macro Call(Fn, X) Fn(X, 1) #end
Show("function", Call(F, 3))
#Show("hash before a macro", 1)
