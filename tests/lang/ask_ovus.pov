// What trace and inside say of ovus.
#version 3.7;
#include "ask.inc"
#declare O = ovus { 0.9, 0.4  }
Ask(O)
#declare O = ovus { 0.9, 0.4 rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 0.9, 0.4 inverse }
Ask(O)
#declare O = ovus { 0.9, 0.4 inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 0.9, 0.4 }
AskExtent(O)
#declare O = ovus { 0.6, 0.8  }
Ask(O)
#declare O = ovus { 0.6, 0.8 rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 0.6, 0.8 inverse }
Ask(O)
#declare O = ovus { 0.6, 0.8 inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 0.6, 0.8 }
AskExtent(O)
#declare O = ovus { 0.5, 0.5 sturm  }
Ask(O)
#declare O = ovus { 0.5, 0.5 sturm rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 0.5, 0.5 sturm inverse }
Ask(O)
#declare O = ovus { 0.5, 0.5 sturm inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 0.5, 0.5 sturm }
AskExtent(O)
#declare O = ovus { 1, 0  }
Ask(O)
#declare O = ovus { 1, 0 rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 1, 0 inverse }
Ask(O)
#declare O = ovus { 1, 0 inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = ovus { 1, 0 }
AskExtent(O)
