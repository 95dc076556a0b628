// The compounds, their words and bare identifiers.
#version 3.7;
#declare S = sphere { 0, 1 }
#declare B = box { 0, 1 }
union { object { S } B split_union off }
merge { sphere { 0, 1 } S translate x }
#declare I = intersection { object { S } object { B } cutaway_textures }
difference { sphere { 0, 1 } B bounded_by { S } }
composite { sphere { 0, 1 } B }
union { } union { sphere { 0, 1 } }
S
box { S translate x }
#debug "ok\n"
