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

# The files that the rows of a list name, in `result`: where the row begins with `head`, then comes the
# file's name. They stand in `folder`.
function(word_files result list head folder)
	set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
	file(STRINGS ${list} files REGEX "^${head}, [a-z0-9_]+")
	list(TRANSFORM files REPLACE "^${head}, ([a-z0-9_]+).*" "${folder}/\\1.c")
	list(REMOVE_DUPLICATES files)
	list(REMOVE_ITEM files ${folder}/none.c)
	set(${result} ${files} PARENT_SCOPE)
endfunction()

# The files of the objects that shapes.def says are made in a room.
function(shape_files result room)
	word_files(files ${PROJECT_SOURCE_DIR}/language/include/language/shapes.def
		"[A-Z]+\\([A-Z0-9_]+, [a-z0-9_]+, ${room}" shape)
	set(${result} ${files} PARENT_SCOPE)
endfunction()
