// Elements of an array can be read into if the type of its elements is known.
#version 3.7;
#declare A = array[3] { 0, 0, 0 }
#fopen F "dir_file_read_element.txt" read
#for (I, 0, 2) #read (F, A[I]) #end
#debug concat(str(A[0], 0, 0), str(A[1], 0, 0), str(A[2], 0, 0), "\n")
