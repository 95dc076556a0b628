// point_at belongs to lights that have a direction.
#version 3.7;
light_source { 9*y, rgb 1 point_at 0 }
