#version 3.7;
#declare C = rgb <1, 0, 0>;
#declare O = sphere { 0, 1 }
object { O C }
sphere { 0, 1 scale 2 C }
union { object { O } sphere { x, 1 } C }
