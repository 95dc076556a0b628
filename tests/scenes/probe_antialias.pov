// switches: +A0.1 +AM2 +R3 -J
// The same as probe.pov with recursive antialiasing.
#include "probe.pov"
