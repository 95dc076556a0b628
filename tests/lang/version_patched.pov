#version unofficial megapov 1.2;
sphere { 0, 1 }
