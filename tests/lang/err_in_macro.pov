#version 3.7;
#macro A(X) B(X) #end
#macro B(X) sphere { 0, X.q } #end
A(1)
