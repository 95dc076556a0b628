// Before version 1.5 there are sums in parentheses only: elsewhere a sign begins a number.
#version 1.0
#declare V = <1 2 -3>
#declare W = <1 -2 (4 -1)>
#declare F = (3 -1)
#declare G = -1
#version 1.5
#declare X = <1 -3, 2>
#version 3.7;
#debug concat(vstr(3, V, " ", 0, 1), "\n")
#debug concat(vstr(3, W, " ", 0, 1), "\n")
#debug concat(str(F, 0, 1), " ", str(G, 0, 1), "\n")
#debug concat(vstr(3, X, " ", 0, 1), "\n")
