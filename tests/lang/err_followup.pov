// What follows from an object that is refused is no error of its own: one message for each cause.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = sphere_sweep { linear_spline 2, 0, 1, y, 1 };
#declare H = max_extent(S).x;
#declare Half = H / 2;
#ifndef (Half) #error "no Half" #end
sphere { 0, H }
#declare N = trace(S, -5*z, z, H);
#declare Rows = array[2] { Half, N.y }
#macro Ball(R) sphere { 0, R + H } #end
object { Ball(Half) }
#declare F = function(x) { x + Half }
sphere { 0, F(2) }
#declare Rows[0] = 4;
#ifdef (Rows[0]) #warning "never known" #end
union { object { S } box { -1, Rows[0] } }
object { S translate Half*x }
#undef Half
#declare H = 1;
sphere { 0, H }
sphere { 0, Hh }
