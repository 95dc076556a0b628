// datetime needs a format that says something.
#version 3.7;
#declare S = datetime(0, "");
