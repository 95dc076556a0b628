// Behind the period the name of a component must follow.
#version 3.7;
#declare V = <1, 2, 3>;
#declare A = V.foo;
