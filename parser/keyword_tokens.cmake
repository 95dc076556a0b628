# SPDX-License-Identifier: MIT
# Makes the grammar whole: puts the terminals of keywords.def where grammar.y says @KEYWORDS@, and those
# of the SHAPE rows of shapes.def where it says @SHAPES@.
#
#   cmake -DGRAMMAR=grammar.y -DWORDS=folder of the lists -DOUTPUT=… -P keyword_tokens.cmake
cmake_minimum_required(VERSION 3.25)
file(STRINGS ${WORDS}/keywords.def tokens REGEX "^KEYWORD")
list(TRANSFORM tokens REPLACE "^KEYWORD\\((.*), (.*)\\)$" "%token <keyword> KW_\\2 \"\\1\"")
list(JOIN tokens "\n" tokens)
file(STRINGS ${WORDS}/shapes.def shapes REGEX "^SHAPE")
list(TRANSFORM shapes REPLACE "^SHAPE\\(([A-Z0-9_]*),.*$" "KW_\\1")
list(JOIN shapes " | " shapes)

file(READ ${GRAMMAR} grammar)
string(FIND "${grammar}" "@KEYWORDS@" place)
string(SUBSTRING "${grammar}" 0 ${place} head)
string(REGEX MATCHALL "\n" lines "${head}")
list(LENGTH lines line)
math(EXPR line "${line} + 2") # behind the mark; messages speak of the grammar's own lines
string(REPLACE "@KEYWORDS@" "${tokens}\n#line ${line} \"${GRAMMAR}\"" grammar "${grammar}")
string(REPLACE "@SHAPES@" "${shapes}" grammar "${grammar}")
file(WRITE ${OUTPUT} "#line 1 \"${GRAMMAR}\"\n${grammar}")
