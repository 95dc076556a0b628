// As in C.
#include <colors.inc>
