// The name of an include file, nearly.
#include "err_undeclared_inclde.inc"
