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

# The last words of a suite, and its exit status.
tally() {
	echo "$passed passed, $failed failed"
	[ "$failed" -eq 0 ]
}

# Where the standard includes and the fonts are.
# shellcheck disable=SC2034 # for the runners
includes=/usr/share/povray-3.7/include

# What povray calls its version.
povray_version() {
	HOME=/nonexistent povray --version 2>&1 | sed -n 's/^POV-Ray \([^ ]*\).*/\1/p'
}
