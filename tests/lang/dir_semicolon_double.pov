// One more semicolon behind an expression is swallowed.
#version 3.7;
#declare A = 1;; #declare B = x;; #declare C = rgb 1;;
#debug "passed\n"
