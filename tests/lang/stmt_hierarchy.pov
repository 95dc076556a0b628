// hierarchy belongs to blobs, meshes and height fields.
#version 3.7;
box { 0, 1 hierarchy off }
