// rand(seed(5)) is the first number of a new stream each time.
#version 3.7;
#debug concat(str(rand(seed(5)), 0, 9), " ", str(rand(seed(5)), 0, 9), " ", str(seed(5), 0, 0), "\n")
