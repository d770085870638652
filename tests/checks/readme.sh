#!/bin/sh
# README.md and assets/help/: every path that they name exists, README.md has at most 200 lines, no line of a help text
# is longer than 100 columns, and every `clearance help TOPIC` has its text. Prints every breach.
set -u
cd "$(dirname "$0")/../.."
breaches=$(mktemp)
trap 'rm -f "$breaches"' EXIT

# Paths begin with a folder or file of the source tree. What a command would write (out/, build/) is not looked at.
grep -noE '(\.ci|app|engine|tests|assets|houses)/[A-Za-z0-9_./*-]*[A-Za-z0-9_/*]|LICENSE' README.md assets/help/*.txt |
    sed -E 's/^([^:]+):([0-9]+):(.*)$/\1 \2 \3/' | sort -u |
    while read -r file line path; do
        # the program itself, in a build folder
        case $path in app/clearance) continue ;; esac
        # shellcheck disable=SC2086 # a * stands for itself in the shell, too
        ls -d $path >/dev/null 2>&1 || echo "$file:$line: there is no $path"
    done >>"$breaches"

[ "$(wc -l <README.md)" -le 200 ] || echo "README.md has more than 200 lines" >>"$breaches"
awk 'length > 100 { print FILENAME ":" FNR ": longer than 100 columns" }' assets/help/*.txt >>"$breaches"
for text in assets/help/*.txt; do
    head -1 "$text" | grep -q '^[A-Z][A-Za-z ]*: ' || echo "$text: its first line is not \"Title: what it explains\"" >>"$breaches"
done
grep -ohE 'clearance help [a-z]+( file|-file)?' README.md assets/help/*.txt app/options/*.c | sort -u |
    sed 's/clearance help //; s/ /-/' | while read -r topic; do
        case $topic in options | run) continue ;; esac
        [ -f "assets/help/$topic.txt" ] || echo "there is no topic $topic"
    done >>"$breaches"

cat "$breaches"
count=$(wc -l <"$breaches")
echo "readme: $count breaches"
[ "$count" -eq 0 ]
