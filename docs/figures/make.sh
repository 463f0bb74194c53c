#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# make.sh [BINARIES [FOLDER]]: draws the paper's Figures 1 to 4 and the other pictures of the documentation again, from runs.
# The picture of the viewer needs Chromium and is left as it is without one, or with CONFIDEL_NO_SCREENSHOT set.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
bin=$(cd "${1:-$root/build/release/bin}" && pwd)
mkdir -p "${2:-$here}"
out=$(cd "${2:-$here}" && pwd)
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT
cd "$runs"

conform() { "$bin/confidel" conform "$root/examples/$1" -o "$2" --strategy "$3" --quiet >/dev/null; }
# draw CERT PICTURE LAYERS [OPTIONS]
draw() {
  local certificate=$1 picture=$2 layers=$3
  shift 3
  "$bin/confidel" draw "$certificate" -o "$out/$picture" --layers "$layers" --no-panel --quiet "$@"
}
has_strategy() { "$bin/confidel" conform --help | grep -qw -- "$1"; }

conform house.poly house.cert graded
"$bin/confidel" draw house.cert -o "$out/house.svg" --quiet

# Figure 1: Saalfeld's algorithm protects the vertices, then covers the edges with empty circles.
baseline=house.cert
if has_strategy saalfeld; then conform house.poly saalfeld.cert saalfeld; baseline=saalfeld.cert; fi
draw $baseline figure-1a.svg input,circles,points --window 3.4 0.4 10.8 5.9
draw $baseline figure-1b.svg input,diametral,points --window 3.4 0.4 10.8 5.9

# Figure 2: a vertex, its protecting circle, the spokes. Figure 3: the same intervals on a segment and its two protectors.
draw house.cert figure-2.svg input,circles,buffer,points --window 4.3 3.3 5.7 4.7
draw house.cert figure-3.svg input,rows,buffer,points --window 4.9 1.2 7.7 4.1

# Figure 4: a PSLG, circles and protecting edges, what Chew's algorithm gets, the triangulation of the buffer zones.
draw house.cert figure-4a.svg input --window -0.3 -0.3 12.3 11.3
draw house.cert figure-4b.svg input,circles,rows,points --window -0.3 -0.3 12.3 11.3
draw house.cert figure-4c.svg chew-boundary --window -0.3 -0.3 12.3 11.3
draw house.cert figure-4d.svg input,buffer --window -0.3 -0.3 12.3 11.3

if command -v chromium >/dev/null && [ -z "${CONFIDEL_NO_SCREENSHOT:-}" ]; then
  conform w3.smesh w3.cert graded
  "$bin/confidel" draw w3.cert -o w3.html --quiet
  python3 -B "$here/screenshot.py" w3.html "$out/viewer.png"
fi
