#!/bin/bash
# SPDX-License-Identifier: MIT
# OpenImageIO reads samples of PNM files one too low, or cut instead of rounded.
#
# A 16-bit PGM holds its samples as they are: with a maximum of 65535 nothing has to be scaled. oiiotool gives
# every sample above 32768 one too low; white becomes 65534, and a test for "all of it is white" fails. Where a
# maximum is not 255 or 65535 the samples are scaled, and what is left over is cut off: 63 of 100 is 160.65 of 255
# and read as 160. netpbm gives the exact samples in the first case and the nearest in the second.
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

# samples FILE: what oiiotool reads.
samples() {
	oiiotool --dumpdata "$1" | sed -n 's/^ *Pixel ([0-9]*, 0): \([0-9]*\) .*/\1/p' | paste -sd' '
}

# by_netpbm FILE MAXIMUM
by_netpbm() {
	pamdepth "$2" "$1" 2>/dev/null | pnmtoplainpnm | tail -n +4 | xargs
}

echo "OpenImageIO $(oiiotool --version), $(pamfile --version 2>&1 | sed -n '1s/.*Version: //p')"
printf 'P2\n5 1\n65535\n0 32768 40000 65534 65535\n' >sixteen.pgm
printf 'P5\n5 1\n65535\n\0\0\200\0\234\100\377\376\377\377' >raw.pgm
printf 'P2\n4 1\n100\n0 50 63 100\n' >hundred.pgm
expect 'as text, 0 32768 40000 65534 65535 read by oiiotool' '0 32768 39999 65533 65534' "$(samples sixteen.pgm)"
expect 'raw, the same read by oiiotool' '0 32768 39999 65533 65534' "$(samples raw.pgm)"
expect 'read by netpbm' '0 32768 40000 65534 65535' "$(by_netpbm raw.pgm 65535)"
expect '0 50 63 100 of 100 read by oiiotool' '0 127 160 255' "$(samples hundred.pgm)"
expect 'read by netpbm' '0 128 161 255' "$(by_netpbm hundred.pgm 255)"
exit $changed
