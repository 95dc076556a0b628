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

# What POV-Ray needs to know besides the scene: quiet, no window, where the includes are.
povray_quiet=(-D -GA -V +L/usr/share/povray-3.7/include)

povray_version() {
	HOME=/nonexistent povray --version 2>&1 | sed -n 's/^POV-Ray \([^ ]*\).*/\1/p'
}

# matches TEXT: whether what `lambert diff` printed means a match.
matches() {
	awk '
		/within 2/ && match($0, /[0-9.]+ *%/) { share = substr($0, RSTART, RLENGTH) + 0 }
		tolower($0) ~ /rmse/ && !rmse && match($0, /[0-9.]+$/) { rmse = substr($0, RSTART, RLENGTH) }
		END { exit !(share >= 99.5 && rmse != "" && rmse <= 1.5) }' <<<"$1"
}
