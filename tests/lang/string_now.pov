// now counts days since 2000: later than the year 2020, and it is a plain float.
#version 3.7;
#debug concat(str((now > 7300), 0, 0), " ", str((now < 40000), 0, 0), "\n")
