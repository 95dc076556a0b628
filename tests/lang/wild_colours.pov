// Colours as people reckon with them.
#declare C=rgb<1,0,0>;
#declare D=C*0.5+<0.1,0.1,0.1>; #debug concat(vstr(5,D,",",0,3),"\n")
#declare E = rgb C*0.5 + 0.2; #debug concat(vstr(5,E,",",0,3),"\n")
#declare F = rgbf <1,0,0,0.5>*0.5; #debug concat(vstr(5,F,",",0,3),"\n")
#declare G = color C filter 0.3; #debug concat(vstr(5,G,",",0,3)," ",str(G.filter,0,2)," ",str(G.gray,0,3),"\n")
#declare H = (C+<0,1,0>)/2; #debug concat(vstr(5,H,",",0,3),"\n")
#declare I = rgb <1,2,3,4>; #debug concat(vstr(5,I,",",0,3),"\n")
