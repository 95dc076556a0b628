// What a polynomial may not say.
#version 3.7;
polynomial { 3, xyz(2, 2, 0): 1, xyz(0, 0, 4): 1 }
polynomial { 3, xyz(-1, 0, 0): 1, xyz(1, 1, 1): 1 }
polynomial { 36, xyz(1, 1, 1): 1 }
polynomial { 1, xyz(1, 0, 0): 1 }
