// Everything close together, and commas left out.
#declare i=0;#while(i<5)sphere{<i,0,0>.5 pigment{rgb<i/5,0,0>}}#declare i=i+1;#end
#debug concat("i=",str(i,0,0)"\n")
light_source{<0,10,-10>rgb 1}camera{location<0,0,-10>look_at<2,0,0>}
#macro DoIt(N, V, S) #debug concat(S, str(N,0,0), vstr(3,V,",",0,0), "\n") #end
DoIt(1 <1,2,3> "x") DoIt(1, 2, "y",) DoIt (3,
  <1,
2,3>, concat("a","b"))
# declare A = 2; #   if (A = 2) # debug "yes\n" #  end
