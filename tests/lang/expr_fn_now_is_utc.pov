// now counts days.
#version 3.7;
#declare A = now;
#debug concat(datetime(0), " ", datetime(0.5, "%H:%M"), " ", str((now - A < 1/24), 0, 0), "\n")
