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

# The files that shapes.def names for a room, in `result`.
function(shape_files result room)
	set(list ${PROJECT_SOURCE_DIR}/language/include/language/shapes.def)
	set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
	set(row "^(SHAPE|BLOCK)\\([A-Z0-9_]+, [a-z0-9_]+, ${room}, ([a-z0-9_]+),.*")
	file(STRINGS ${list} files REGEX "${row}")
	list(TRANSFORM files REPLACE "${row}" "shape/\\2.c")
	list(REMOVE_DUPLICATES files)
	set(${result} ${files} PARENT_SCOPE)
endfunction()
