# SPDX-License-Identifier: MIT
# A room: a folder of the library with what it offers and what it keeps to itself.
#
#   room(NAME USES ROOM... SOURCES FILE...)
#
# The headers under include/NAME/ are the room's door: the rooms that use it include them as NAME/file.h.
# All other headers are its own. A file that includes a header of a room it does not use does not compile.
function(room name)
	cmake_parse_arguments(ROOM "" "" "USES;SOURCES" ${ARGN})
	add_library(${name} OBJECT ${ROOM_SOURCES})
	target_include_directories(${name} PUBLIC include PRIVATE .)
	target_link_libraries(${name} PUBLIC ${ROOM_USES})
	target_compile_options(${name} PRIVATE "$<$<COMPILE_LANGUAGE:C>:${LAMBERT_WARNINGS}>")
endfunction()
