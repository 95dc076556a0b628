#version 3.7;
camera { orthographic location -z angle }
camera { location -z angle }
camera { location -z angle 40, 30 }
camera { spherical angle 40, 30 location 0 }
