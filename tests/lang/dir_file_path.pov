// A file to read is looked for in the library, too; its name may be computed.
#version 3.7;
#fopen F concat("dir_file_read_", "end.txt") read
#read (F, A)
#debug concat(str(A, 0, 0), str(file_exists("dir_file_read_end.txt"), 0, 0),
	str(file_exists("none"), 0, 0), "\n")
