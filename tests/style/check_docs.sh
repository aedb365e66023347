#!/usr/bin/env bash
# Code in the pages is code that compiles: every line of a ```cpp block stands in the FILE that a comment <!-- code of FILE -->
# above it names. So do the lines of other blocks below such a comment: JSON, CMake, commands.
# What the pages link to and name exists (check_links.py).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
status=0
for page in README.md CONTRIBUTING.md docs/*.md docs/*/*.md; do
    file=
    inside=
    number=0
    while IFS= read -r line; do
        number=$((number + 1))
        if [[ $line =~ ^'<!-- code of '(.+)' -->'$ ]]; then
            file=${BASH_REMATCH[1]}
        elif [ "$line" = '```cpp' ] || { [[ $line == '```'?* ]] && [ -n "$file" ]; }; then
            inside=yes
        elif [ "$line" = '```' ]; then
            inside=
            file=
        elif [ -n "$inside" ] && [ -n "$line" ]; then
            [ -n "$file" ] || { echo "$page:$number: code without a comment <!-- code of FILE --> above it" >&2; exit 1; }
            grep -qxF -- "$line" "$file" || { echo "$page:$number: not a line of $file: $line" >&2; status=1; }
        fi
    done < "$page"
done
"tests/style/check_links.py" || status=1
exit $status
