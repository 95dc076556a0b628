#!/bin/bash
# SPDX-License-Identifier: MIT
# pfstools turn a black channel into a negative one.
#
# Between two tools of a pipe a picture travels as XYZ, so that even a file that is only copied from one format to
# another is turned to XYZ and back in single precision, and does not come back exact. A channel that is 0 in the
# Radiance file comes out below 0, and 1.0 does not come out as 1.0. A renderer that takes such a map as a light
# source gets negative light; a logarithm or a square root gives not-a-number.
# Exit status: 0 when this is still so, 1 when something has changed, 2 when the packages cannot be fetched.
set -euo pipefail
packages=(pfstools=2.2.0-5+b1 libpfs2=2.2.0-5+b1)

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
if ! apt-get -qq -o APT::Sandbox::User="$(id -un)" download "${packages[@]}"; then
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

echo "${packages[*]}"
# one pixel: red 1, green 0.5, blue 0
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\200\100\0\201' >copied.hdr
pfsinrgbe copied.hdr 2>/dev/null | pfsoutpfm copied.pfm 2>/dev/null
expect 'Radiance file, mantissas and exponent' '128 64 0 129' "$(tail -c 4 copied.hdr | od -An -tu1 | xargs)"
expect 'the same as PFM' '1.0000001 0.5000001 -4.4703484e-08' "$(tail -c 12 copied.pfm | od -An -tf4 | xargs)"
exit $changed
