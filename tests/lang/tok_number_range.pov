// ".." and "1.5.x": a period that no digit follows is a token of its own.
#version 3.7;
#declare V = <4, 5, 6>;
#debug concat(str(V.y, 0, 0), str(V . z, 0, 0), str(V. x, 0, 0), str(V /* a */ . // b
  y, 0, 0), "\n")
