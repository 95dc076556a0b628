// Colour identifiers are operands: products, sums with shorter vectors, components.
#version 3.7;
#declare G = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
#debug concat(vstr(5, G*2, " ", 0, 4), "\n")
#debug concat(vstr(5, G + u, " ", 0, 4), "\n")
#debug concat(vstr(5, G + G*0.5, " ", 0, 4), "\n")
#debug concat(str(G.red, 0, 3), str(G.green, 0, 3), str(G.blue, 0, 3), str(G.filter, 0, 3), "\n")
#debug concat(str(G.transmit, 0, 3), str(G.x, 0, 3), str(G.t, 0, 3), str(G.gray, 0, 6), "\n")
