// Habits from other languages, and the usual slips.
#version 3.7;
#declare A = array[2] { 1, 2 }
#declare F = function(x) { x }
#declare R = 1
sphere { 0, R == 1 }
#declare B = F();
#declare C = sin();
#declare D = 1,5;
B = 2;
sphere { 0, A(1) }
sphere { 0, B }
sphere { 0, 1 translate 1, 2, 3 }
sphere { 0, 1 pigment { rgb (1, 0, 0) } }
text { ttf 'cyrvetic.ttf' "A" 1, 0 }
sphere { 0, 1 };
sphere { 0, 2* translate 1 }
camera {
	location <0, 1, 2
	look_at 0
}
#decalre G = 1;
sphere { 0, G }
