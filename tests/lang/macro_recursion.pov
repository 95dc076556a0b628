// Macros may call themselves and one another.
#version 3.7;
#macro Even(N) #if (N = 0) #debug "even\n" #else Odd(N - 1) #end #end
#macro Odd(N) #if (N = 0) #debug "odd\n" #else Even(N - 1) #end #end
Even(7) Even(10)
#macro Gcd(A, B) #if (B = 0) #local R = A; #else #local R = Gcd(B, mod(A, B)); #end R #end
#debug concat(str(Gcd(48, 36), 0, 0), "\n")
