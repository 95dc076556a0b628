# SPDX-License-Identifier: MIT
# For the runners of the suites: counts, and the one line each suite ends with.
# shellcheck shell=bash
passed=0
failed=0

pass() {
	passed=$((passed + 1))
}

# fail NAME REASON: what differed is told at once.
fail() {
	failed=$((failed + 1))
	printf 'FAIL %s: %s\n' "$1" "$2"
}

# open_suite SUITE [--references] [LAMBERT [PATTERN]]: the arguments of a runner. Answers of povray are kept in
# `cache`; what a build makes is in `work`, so that the suites of several builds may run at a time.
# shellcheck disable=SC2034 # for the runners
open_suite() {
	local suite=$1
	shift
	references=false
	if [ "${1:-}" = --references ]; then references=true && shift; fi
	lambert=$(realpath -m -- "${1:-build/release/lambert}")
	pattern=${2:-*}
	cache=$PWD/build/tests/$suite
	work=$cache/$(basename "$(dirname "$lambert")")
	mkdir -p "$work"
}

# The last words of a suite, and its exit status. tally [LEAST]: a suite that has fewer than LEAST cases has
# lost some; with a pattern one is enough, and none is always a failure.
tally() {
	local cases=$((passed + failed)) least=${1:-1}
	if [ "${pattern:-*}" != '*' ]; then least=1; fi
	if [ "$cases" -lt "$least" ]; then
		fail "$(basename "$(dirname "$0")")" "ran $cases cases, not at least $least"
	fi
	echo "$passed passed, $failed failed"
	[ "$failed" -eq 0 ]
}

# at_once FUNCTION NAME...: calls the function with each name, many at a time and in silence. Each start of
# povray waits for half a second, and answers that are already there cost nothing later.
at_once() {
	local call=$1 name
	shift
	for name; do
		while [ "$(jobs -rp | wc -l)" -ge 12 ]; do wait -n || true; done
		"$call" "$name" >/dev/null 2>&1 &
	done
	wait
}

# Where the standard includes and the fonts are.
# shellcheck disable=SC2034 # for the runners
includes=/usr/share/povray-3.7/include

# Sets `version` to what povray calls it. Without povray a suite would compare less: that is a failed case.
find_povray() {
	# shellcheck disable=SC2034 # for the runners
	version=$(HOME=/nonexistent povray --version 2>&1 | sed -n 's/^POV-Ray \([^ ]*\).*/\1/p')
	[ -n "$version" ] || fail povray "is not installed: nothing can be compared with its answers"
}
