#!/bin/bash
# SPDX-License-Identifier: MIT
# OpenImageIO refuses run-length BMP files whose last row has its end of line.
#
# In an 8-bit BMP with runs, "0 0" ends a row and "0 1" ends the picture. Writers commonly end each row with the first and
# then the picture with the second. oiiotool reads a file only when the last "0 0" is left out; with it, it calls the
# file corrupt, because it has gone to a row above the last one although no pixel is put there. netpbm reads both.
# Exit status: 0 when this is still so, 1 when something has changed, 2 when the packages cannot be fetched.
set -euo pipefail
packages=(openimageio-tools=2.4.7.1+dfsg-2 libopenimageio2.4=2.4.7.1+dfsg-2 netpbm=2:11.01.00-2 libnetpbm11=2:11.01.00-2)

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# and the libraries it needs that are not installed here
more=$(apt-get -s install --no-install-recommends "${packages[@]}" | awk '$1 == "Inst" { print $2 }')
# shellcheck disable=SC2086 # a list of words
if ! apt-get -qq -o APT::Sandbox::User="$(id -un)" download "${packages[@]}" $more; then
	echo "Could not download the packages; is the list of packages up to date (apt-get update)?" >&2
	exit 2
fi
for package in *.deb; do dpkg -x "$package" unpacked; done
PATH=$PWD/unpacked/usr/bin:$PATH
LD_LIBRARY_PATH=$(echo "$PWD"/unpacked/usr/lib "$PWD"/unpacked/usr/lib/*-linux-gnu "$PWD"/unpacked/usr/lib/*-linux-gnu/*/ | tr ' ' :)
export PATH LD_LIBRARY_PATH

# expect NAME EXPECTED GOT
changed=0
expect() {
	printf '%s: %s\n' "$1" "$3"
	if [ "$2" != "$3" ]; then
		echo "  changed: was $2"
		changed=1
	fi
}

# bmp SIZE RUNS: a picture of 4 x 2 pixels, palette red and blue, with SIZE (octal, below 256) bytes of runs.
bmp() {
	printf 'BM\176\0\0\0\0\0\0\0\76\0\0\0'
	printf '\50\0\0\0\4\0\0\0\2\0\0\0\1\0\10\0\1\0\0\0'"\\$1"'\0\0\0\0\0\0\0\0\0\0\0\2\0\0\0\2\0\0\0'
	printf '\0\0\377\0\377\0\0\0'
	printf "$2"
}

# first FILE: the first row as oiiotool reads it, or what it complains of.
first() {
	local said
	if said=$(oiiotool --dumpdata "$1" 2>&1); then
		sed -n 's/^ *Pixel (\([0-9]*\), 0): \([0-9 ]*\) (.*/\2/p' <<<"$said" | paste -sd,
	else
		sed -n 's/.*\(BMP might be corrupted\).*/\1/p' <<<"$said"
	fi
}

echo "OpenImageIO $(oiiotool --version), $(pamfile --version 2>&1 | sed -n '1s/.*Version: //p')"
bmp 12 '\4\0\0\0\2\1\2\0\0\1' >short.bmp
bmp 14 '\4\0\0\0\2\1\2\0\0\0\0\1' >usual.bmp
expect 'oiiotool, without the last end of line' '0 0 255,0 0 255,255 0 0,255 0 0' "$(first short.bmp)"
expect 'oiiotool, with it' 'BMP might be corrupted' "$(first usual.bmp)"
for file in short usual; do
	expect "netpbm, $file" '0 0 255 0 0 255 255 0 0 255 0 0' \
		"$(bmptopnm $file.bmp 2>/dev/null | pnmtoplainpnm | sed -n 4p | xargs)"
done
exit $changed
