#version 3.7;
#fopen F "/tmp/lambert_test_escape.txt" write
