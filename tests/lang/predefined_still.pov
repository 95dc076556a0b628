// The identifiers of a still picture.
#version 3.7;
#debug concat(str((image_width > 1), 0, 0), " ", str((image_height > 1), 0, 0), "\n")
#debug concat(str(frame_number, 0, 0), str(initial_frame, 0, 0), str(final_frame, 0, 0), " ")
#debug concat(str(initial_clock, 0, 0), str(final_clock, 0, 0), str(clock_delta, 0, 0), "\n")
#debug concat(str(clock, 0, 3), str(clock_on, 0, 0), " ", str(pi, 0, 15), "\n")
