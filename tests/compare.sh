# SPDX-License-Identifier: MIT
# For the suites that compare pictures: lambert's beside POV-Ray's, made by the installed povray with the same
# switches and kept in the suite's `cache`. After tests/tally.sh, open_suite and find_povray; the current
# folder is that of the scenes.
#
# A scene matches when at least 99.5 % of the pixels are within 2/255 and the RMSE is at most 1.5/255. A first
# line "// switches: ..." replaces the usual switches; it may name NAME.ini.
# shellcheck shell=bash disable=SC2154 # lambert, cache, work, includes: tests/tally.sh
quiet=(-D -GA -V "+L$includes")

# switches_of NAME USUAL: sets `switches`.
switches_of() {
	local own
	own=$(sed -n '1s|^// switches: ||p' "$1.pov")
	read -ra switches <<<"${own:-$2}"
}

# POV-Ray's picture of a scene, from the cache or made now; prints its path.
reference() {
	local name=$1 key picture folder status=0
	switches_of "$name" "+W80 +H60 -A"
	key=$({ cat "$name".pov "$name".ini 2>/dev/null; echo "${switches[*]} $version"; } | sha256sum | cut -c1-16)
	picture=$cache/$name-$key.png
	if [ ! -e "$picture" ]; then
		# in a folder of its own: another suite may make the same picture
		folder=$(mktemp -d "$cache/$name.XXXXXX")
		HOME=/nonexistent povray "+I$name.pov" "${switches[@]}" "${quiet[@]}" "+O$folder/picture.png" \
			>"$cache/$name.povray.log" 2>&1 </dev/null || status=$?
		[ "$status" -ne 0 ] || mv "$folder/picture.png" "$picture"
		rm -rf "$folder"
		[ "$status" -eq 0 ] || return 1
	fi
	echo "$picture"
}

# The first error of a scene's log, else its last words.
complaint() {
	grep -m 1 error "$work/$1.log" || tail -n 1 "$work/$1.log"
}

# compared SUITE NAME: passes or fails the scene.
compared() {
	local suite=$1 name=$2 theirs said
	switches_of "$name" "+W80 +H60 -A"
	rm -f "$work/$name.png"
	if ! theirs=$(reference "$name"); then
		fail "$suite/$name" "no picture by povray, see $cache/$name.povray.log"
	elif ! "$lambert" render "$name.pov" "${switches[@]}" "${quiet[@]}" "+O$work/$name.png" \
		>"$work/$name.log" 2>&1; then
		fail "$suite/$name" "$(complaint "$name")"
	elif [ ! -s "$work/$name.png" ]; then
		fail "$suite/$name" "no picture by lambert"
	elif said=$("$lambert" diff "$theirs" "$work/$name.png" --heatmap "$work/$name-heatmap.png" 2>&1); then
		pass
	else
		fail "$suite/$name" "differs from POV-Ray's picture: $theirs $work/$name.png"
		echo "$said"
	fi
}
