// strupr and strlwr map the letters of ASCII only.
#version 3.7;
#debug concat(strupr("Straight 4 you_[z]"), strlwr(" ABC-XYZ@Z"), strupr(strlwr("Both")), "\n")
