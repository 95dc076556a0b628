// & and | bind alike: 1|0&0 is (1|0)&0.
#version 3.7;
#debug concat(str((1 | 0 & 0), 0, 0), str((0 & 0 | 1), 0, 0), str((0 & 1 | 1 & 0), 0, 0), "\n")
