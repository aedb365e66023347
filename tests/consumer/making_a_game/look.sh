#!/bin/sh
# The program's window comes up, and stays until it is told to end: look.sh PROGRAM LEVEL FOLDER
cd "$3"
"$1" "$2" &
program=$!
xdotool search --sync --onlyvisible --name '^My room$' || { kill $program; exit 1; }
kill -TERM $program
wait $program
[ $? = 143 ]
