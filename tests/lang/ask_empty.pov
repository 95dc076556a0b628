// An empty union or merge is nowhere, its inverse everywhere, an empty intersection everywhere, whatever they are part of.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "ask.inc"
#declare S = sphere { 0, 1 }
#declare L = light_source { <2,4,-5>, rgb 0.2 }
#macro Ask(O)
	#local N = <0, 0, 0>;
	#local P = trace(O, <0.1,0.2,-9>, z, N);
	#debug concat(str(inside(O, 0), 0, 0), str(inside(O, 5*x), 0, 0), str(inside(O, 1e6*x), 0, 0), " ")
	#debug concat(vstr(3, P, " ", 0, 3), " | ", vstr(3, N, " ", 0, 3), " | ")
	AskExtent(O)
#end
#macro AskAll(O)
	Ask(difference { sphere { S } object { O } })
	Ask(difference { object { O } sphere { S } })
	Ask(intersection { sphere { S } object { O } })
	Ask(union { sphere { S } object { O } })
	Ask(merge { sphere { S } object { O } })
	Ask(intersection { object { O inverse } sphere { S } })
	Ask(union { sphere { S } object { O inverse } })
	Ask(merge { sphere { S } object { O inverse } })
	Ask(difference { sphere { S } object { O inverse } })
	Ask(difference { sphere { S } object { O } inverse })
	Ask(sphere { 0, 1 clipped_by { object { O } } })
	Ask(sphere { 0, 1 clipped_by { object { O inverse } } })
	Ask(sphere { 0, 1 bounded_by { object { O } } })
	Ask(sphere { 0, 1 bounded_by { object { O inverse } } })
	Ask(object { O clipped_by { sphere { S } } })
	Ask(object { O bounded_by { sphere { S } } })
	Ask(object { O inverse })
	Ask(object { O translate 2*x rotate 30*y })
#end
AskAll(union { })
AskAll(merge { })
AskAll(intersection { })
AskAll(difference { })
AskAll(union { union { } merge { } })
AskAll(intersection { union { } intersection { } })
AskAll(merge { intersection { } union { } })
AskAll(text { ttf "timrom.ttf" " " 1, 0 })
// What has only lights may not be asked for its inside.
#macro AskLights(O)
	Ask(difference { sphere { S } object { O } })
	Ask(intersection { sphere { S } object { O inverse } })
#end
AskLights(union { light_source { L } })
AskLights(merge { light_source { L } union { } })
