// An object closed too early leaves several modifiers and a brace behind: one message.
#version 3.7;
sphere { 0, 1 }
	pigment { rgb 1 }
	finish { ambient 1 }
	rotate 3*x
}
Count = 5;
box { 0, Count }
torus { 1, Mistake }
