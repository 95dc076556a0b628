// What trace and inside say of text.
#version 3.7;
#include "ask.inc"
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2> }
Ask(O)
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2>  inverse }
Ask(O)
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2>  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = text { ttf "crystal.ttf" "Qi" 0.4, 0.1*x scale 1.4 translate <-0.7,-0.3,-0.2> }
Ask(O)
#declare O = text { ttf "crystal.ttf" "Qi" 0.4, 0.1*x scale 1.4 translate <-0.7,-0.3,-0.2>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = text { ttf "crystal.ttf" "Qi" 0.4, 0.1*x scale 1.4 translate <-0.7,-0.3,-0.2>  inverse }
Ask(O)
#declare O = text { ttf "crystal.ttf" "Qi" 0.4, 0.1*x scale 1.4 translate <-0.7,-0.3,-0.2>  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
