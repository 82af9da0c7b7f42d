#!/usr/bin/env bash
# bench/verdicts.sh OUT OLD NEW [COMPARISONS]     do the verdicts of scripts/duet hold on this machine?
# COMPARISONS (20) duets of ten pairs, a line of OUT each: verdict, shift in percent with its interval, and how many threads wanted a
# processor meanwhile (load of the last minute). With one program twice "worse" may come once in twenty; with one that is 5 % slower it should come each time.
set -euo pipefail
out=${1:?OUT} old=${2:?OLD} new=${3:?NEW}
duet=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../scripts/duet
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT
small=(--scene cornell --frames 60 --set settle_s=0.05 --set display.eyes=1 --set display.eye_width_px=128 --set display.eye_height_px=128)
echo "# $(nproc) cores, $(sed -nE 's/^model name\s*: //p;T;q' /proc/cpuinfo); old $("$old" --version), new $("$new" --version)" >"$out"
echo "verdict,shift_percent,ci95_low_percent,ci95_high_percent,load_1min" >>"$out"
for ((k = 0; k < ${4:-20}; ++k)); do
    told=$("$duet" "$old" "$new" --out "$runs/$k" "${small[@]}" || (($? == 1)))
    shift=$(sed -nE 's/^shift .*, ([-+0-9.e]+) % \[([^,]*), ([^]]*)\], 95 %$/\1,\2,\3/p' <<<"$told")
    verdict=$(tail -n 1 <<<"$told" | cut -d: -f1)
    case $verdict in
        worse | better | same | "cannot tell") ;;
        *)
            echo "verdicts: scripts/duet gave no verdict" >&2
            exit 5
            ;;
    esac
    echo "$verdict,$shift,$(cut -d' ' -f1 /proc/loadavg)" | tee -a "$out"
    rm -rf "${runs:?}/$k"
done
