# SPDX-License-Identifier: MIT
# Makes the grammar whole: puts the terminals of keywords.def where grammar.y says @KEYWORDS@.
#
#   cmake -DGRAMMAR=grammar.y -DKEYWORDS=keywords.def -DOUTPUT=… -P keyword_tokens.cmake
cmake_minimum_required(VERSION 3.25)
file(STRINGS ${KEYWORDS} tokens REGEX "^KEYWORD")
list(TRANSFORM tokens REPLACE "^KEYWORD\\((.*), (.*)\\)$" "%token <keyword> KW_\\2 \"\\1\"")
list(JOIN tokens "\n" tokens)

file(READ ${GRAMMAR} grammar)
string(FIND "${grammar}" "@KEYWORDS@" place)
string(SUBSTRING "${grammar}" 0 ${place} head)
string(REGEX MATCHALL "\n" lines "${head}")
list(LENGTH lines line)
math(EXPR line "${line} + 2") # behind the mark; messages speak of the grammar's own lines
string(REPLACE "@KEYWORDS@" "${tokens}\n#line ${line} \"${GRAMMAR}\"" grammar "${grammar}")
file(WRITE ${OUTPUT} "#line 1 \"${GRAMMAR}\"\n${grammar}")
