#!/usr/bin/env bash
# bench/verdicts.sh OUT OLD NEW [COMPARISONS]     do the verdicts of scripts/duet hold on this machine?
# COMPARISONS (20) duets of ten pairs, a line of OUT each: verdict, shift in percent with its interval, processor time that went elsewhere. With one
# program twice "worse" may come once in twenty; with one that is 5 % slower it should come each time.
set -euo pipefail
out=${1:?OUT} old=${2:?OLD} new=${3:?NEW}
duet=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../scripts/duet
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT
small=(--scene cornell --frames 60 --set settle_s=0.05 --set display.eyes=1 --set display.eye_width_px=128 --set display.eye_height_px=128)
echo "# $(nproc) cores, $(sed -nE 's/^model name\s*: //p;T;q' /proc/cpuinfo); old $("$old" --version), new $("$new" --version)" >"$out"
echo "verdict,shift_percent,ci95_low_percent,ci95_high_percent,elsewhere_percent" >>"$out"
for ((k = 0; k < ${4:-20}; ++k)); do
    told=$("$duet" "$old" "$new" --out "$runs/$k" "${small[@]}" || (($? == 1)))
    shift=$(sed -nE 's/^shift .*, ([-+0-9.e]+) % \[([^,]*), ([^]]*)\], 95 %$/\1,\2,\3/p' <<<"$told")
    elsewhere=$(sed -nE 's/^machine .*up to ([0-9]+) %.*/\1/p' <<<"$told")
    echo "$(tail -n 1 <<<"$told" | cut -d: -f1),$shift,$elsewhere" | tee -a "$out"
    rm -rf "${runs:?}/$k"
done
