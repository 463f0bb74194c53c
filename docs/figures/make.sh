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

# conform EXAMPLE CERT OPTIONS: a refutation ends with 1, and has a certificate too.
conform() {
  local status=0
  "$bin/confidel" conform "$root/examples/$1" -o "$2" --quiet "${@:3}" >/dev/null || status=$?
  [ "$status" -le 1 ]
}
# draw CERT PICTURE LAYERS OPTIONS
draw() { "$bin/confidel" draw "$1" -o "$out/$2" --layers "$3" --no-panel --quiet "${@:4}"; }

conform house.poly house.cert --strategy graded
"$bin/confidel" draw house.cert -o "$out/house.svg" --quiet

# Figure 1: Saalfeld's algorithm protects the vertices, then covers the edges with empty circles.
conform house.poly saalfeld.cert --strategy saalfeld
draw saalfeld.cert figure-1a.svg input,circles,points --window 3.4 0.4 10.8 5.9
draw saalfeld.cert figure-1b.svg input,diametral,points --window 3.4 0.4 10.8 5.9

# Figure 2: a vertex, its protecting circle, the spokes. Figure 3: the same intervals on a segment and its two protectors.
draw house.cert figure-2.svg input,circles,buffer,points --window 4.3 3.3 5.7 4.7
draw house.cert figure-3.svg input,rows,buffer,points --window 4.9 1.2 7.7 4.1

# Figure 4: a PSLG, circles and protecting edges, what Chew's algorithm gets, the triangulation of the buffer zones.
whole=(--window -1.6 -1.3 13.4 12.6)
draw house.cert figure-4a.svg input "${whole[@]}"
draw house.cert figure-4b.svg input,circles,rows,points "${whole[@]}"
draw house.cert figure-4c.svg chew-boundary "${whole[@]}"
draw house.cert figure-4d.svg input,buffer "${whole[@]}"

conform corner-45.poly corner.cert --strategy paper
draw corner.cert corner-45.svg input,circles,buffer,points,witness

if command -v chromium >/dev/null && [ -z "${CONFIDEL_NO_SCREENSHOT:-}" ]; then
  conform w3.smesh w3.cert --strategy graded
  "$bin/confidel" draw w3.cert -o w3.html --quiet
  python3 -B "$here/screenshot.py" w3.html "$out/viewer.png"
fi
