#!/bin/sh
# Walks, lights the lantern and leaves: keys.sh PROGRAM LEVEL
"$1" "$2" &
program=$!
xdotool search --sync --onlyvisible --name '^walk$' windowfocus --sync keydown w key f keyup w key Escape
wait $program
