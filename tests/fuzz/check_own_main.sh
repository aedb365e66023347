#!/usr/bin/env bash
# What own_main.cpp makes of targets that do wrong: exit codes, findings, an end in time.   check_own_main.sh PROGRAM
set -euo pipefail
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export TMPDIR=$work/tmp
mkdir "$TMPDIR" "$work"/{corpus,findings}
status=0

wrong() {
    printf '%s\n' "$*" >&2
    status=1
}
# run TARGET SECONDS [ARGUMENTS]: with the inputs of $work/corpus; its exit code in $code, its findings' number in $count.
run() {
    rm -f "$work"/findings/*
    code=0
    LANTHORN_FUZZ_TARGET=$1 timeout 60 "$program" -max_total_time="$2" -artifact_prefix="$work/findings/" "${@:3}" "$work/corpus" \
        2> "$work/log" || code=$?
    count=$(find "$work/findings" -type f -name "${kind:-crash}-*" | wc -l)
}
# ends TARGET CODE FINDINGS: how the last run should have ended; findings: a number at least.
ends() {
    [ "$code" -eq "$2" ] && [ "$count" -ge "$3" ] || {
        wrong "$1: exit code $code and $count findings, expected $2 and $3:"
        tail -n 3 "$work/log" >&2
    }
}

printf a > "$work/corpus/a"
run sound 1
ends sound 0 0
grep -q '^#[1-9][0-9]' "$work/log" || wrong "sound: fewer than 10 inputs"

# Two inputs of the corpus end it: both are found, and it goes on with the third.
printf b > "$work/corpus/b"
printf c > "$work/corpus/c"
run refuses 2
ends refuses 1 2
grep -q '^FINDING: b$' "$work/log" || wrong "refuses: does not say b"
grep -q '^#[1-9][0-9]' "$work/log" || wrong "refuses: does not go on after a finding"
# As docs/fuzzing.md says, to look at one.
said=$(LANTHORN_FUZZ_TARGET=refuses "$program" "$work/corpus/b" 2>&1) && wrong "refuses: does not find b alone"
[ "$said" = "FINDING: b" ] || wrong "refuses: says '$said', expected 'FINDING: b'"
rm "$work"/corpus/[bc]

kind=timeout
run works 2 -timeout=1
ends works 1 1
run waits 2 -timeout=1
ends waits 1 1
kind=crash
run takes 1 -rss_limit_mb=100
ends takes 1 1
run leaks 1
ends leaks 1 1
grep -q '^FINDING: it leaks$' "$work/log" || wrong "leaks: does not say so"

# Ctrl+C.
LANTHORN_FUZZ_TARGET=waits "$program" -max_total_time=50 -artifact_prefix="$work/findings/" "$work/corpus" 2> /dev/null &
sleep 1
kill -INT $!
SECONDS=0
code=0
wait $! || code=$?
[ $code -eq 130 ] && [ $SECONDS -le 5 ] || wrong "SIGINT: exit code $code after $SECONDS s, expected 130 at once"

left=$(ls "$TMPDIR")
[ -z "$left" ] || wrong "left behind: $left"
exit $status
