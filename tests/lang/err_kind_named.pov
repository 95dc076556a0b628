// A name of the wrong kind: what is wanted, what the name is, and where it was declared.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Word = "red"; #declare Shade = texture { pigment { rgb 1 } }
#declare List = array[2] { 1, 2 };
#declare Wave = function(x) { x };
#declare Path = spline { 0, x, 1, y }
#declare Ball = sphere { 0, 1 }
#declare Two = 1; #declare Two = 2;
#macro Disc(R) disc { 0, y, R } #end
sphere { 0, 1 pigment { rgb Word } }
sphere { 0, 1 pigment { rgb "red" } }
sphere { 0, 1 pigment { Word } }
sphere { 0, 1 pigment { rgb Shade } }
sphere { 0, 1 pigment { rgb List } }
sphere { 0, Wave }
sphere { 0, 1 scale Path }
sphere { 0, 1 pigment { rgb Disc(1) } }
sphere { 0, Ball }
light_source { 0 color Word }
#declare A = max(1, Word);
#declare A = sin(Ball);
#declare A = Word + 1;
#declare A = Two[0];
object { Disc(Shade) }
sphere { 0, 1 finish { Word } }
