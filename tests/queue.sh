# SPDX-License-Identifier: MIT
# For ./check: runs suites at the same time, one for each processor, and shows what they say one after another.
#
#   suite NAME COMMAND...        puts a runner into the queue
#   long_suite NAME COMMAND...   the same, but it starts before all others, because it takes longest
#   run_suites                   runs them all, shows them in the order of the queue, adds up their last lines
#
# A suite has ten minutes. One that does not end with "N passed, N failed" counts as one failure.
# shellcheck shell=bash
total_passed=0
total_failed=0
logs=build/check
names=()
commands=()
starts=() # the suites in the order in which they start
end='-- the suite has ended --'

suite() {
	starts+=("${#names[@]}")
	names+=("$1")
	shift
	commands+=("$(printf '%q ' "$@")")
}

long_suite() {
	local before=("${starts[@]}")
	suite "$@"
	starts=("${starts[-1]}" "${before[@]}")
}

# run_suite NUMBER: what it says goes to its log, with a last line that tells the reader to stop.
run_suite() {
	eval "timeout --foreground -k 10 600 ${commands[$1]}" >>"$logs/$1.log" 2>&1 </dev/null || true
	echo "$end" >>"$logs/$1.log"
}

start_suites() {
	local number
	for number in "${starts[@]}"; do
		while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
		run_suite "$number" &
	done
	wait
}

# show NUMBER: what a suite says, while it says it.
show() {
	local line='' more
	echo "== ${names[$1]}"
	while :; do
		if IFS= read -r more; then
			line+=$more
			[ "$line" != "$end" ] || return 0
			printf '%s\n' "$line"
			line=
		else
			line+=$more
			sleep 0.2
		fi
	done <"$logs/$1.log"
}

# count NUMBER: adds up the last line of a suite.
count() {
	local counts
	counts=$(tail -n 2 "$logs/$1.log" | sed -n 's/^\([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p')
	if [ -z "$counts" ]; then
		echo "FAIL ${names[$1]}: ended before its time"
		counts="0 1"
	elif [ "$counts" = "0 0" ]; then
		echo "FAIL ${names[$1]}: ran no case"
		counts="0 1"
	fi
	total_passed=$((total_passed + ${counts% *}))
	total_failed=$((total_failed + ${counts#* }))
}

run_suites() {
	local number group
	mkdir -p "$logs"
	for number in "${starts[@]}"; do : >"$logs/$number.log"; done
	set -m # a process group of their own, so that an interrupted ./check can end them all
	start_suites &
	group=$!
	set +m
	# shellcheck disable=SC2064 # the group that is known now
	trap "kill -TERM -- -$group 2>/dev/null || true" EXIT
	for number in "${!names[@]}"; do
		show "$number"
		count "$number"
	done
	wait "$group" || true
	names=() commands=() starts=()
}
