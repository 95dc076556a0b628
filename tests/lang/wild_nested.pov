// Loops within loops, macros that call themselves, halves of statements from macros.
#declare I = 0;
#while (I < 3) #declare J = 0; #while (J < 2) #for (K, 1, 2) #debug concat(str(I,0,0),str(J,0,0),str(K,0,0)," ") #end #declare J = J+1; #end #declare I = I + 1; #end
#debug "\n"
#macro Fact(N) #if (N <= 1) 1 #else N*Fact(N-1) #end #end
#debug concat(str(Fact(5),0,0),"\n")
#macro Fib(N) #if (N < 2) #local R = N; #else #local R = Fib(N-1) + Fib(N-2); #end R #end
#debug concat(str((Fib(10)),0,0),"\n")
#macro Half() sphere { 0, 1 #end
Half() pigment { rgb 1 } }
#macro Coord() 1, 2, 3 #end
#debug concat(vstr(3, <Coord()>, ",", 0, 0), "\n")
#macro Open(A) #if (A) union { #else merge { #end sphere{0,1} sphere{1,1} #end
Open(1) pigment { rgb 1 } }
#macro Outer(A) #macro Inner(B) #debug concat("inner ", str(B,0,0), "\n") #end Inner(A+1) #end
Outer(3) Inner(9)
sphere { 0, 1
  #if (0) pigment { rgb 1 } #else pigment { rgb 0 } #end
  #local I = 0; #while (I < 3) rotate I*x #local I = I+1; #end
  #ifdef (Nope) scale 2 #end }
#debug concat(str(I,0,0),"\n")
