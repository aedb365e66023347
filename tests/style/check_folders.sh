#!/usr/bin/env bash
# A technique is a folder of its own: neither another technique nor what techniques share includes anything of it, C++ or
# shaders, or links it. gi_module/technique.cpp and gi_module/techniques alone, where techniques are made known, name them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
status=0
techniques=(gi_module/*/*_technique.cpp)
[ ${#techniques[@]} -ge 5 ] || { echo "gi_module/*/*_technique.cpp: found ${#techniques[@]}, expected every technique's" >&2; exit 1; }
for technique in "${techniques[@]}"; do
    technique=$(basename "$(dirname "$technique")")
    # A path in an #include, one that a program is made of, or a library.
    found=$(grep -rnE "\"(lanthorn/(gi/)?|gi_module/|(\.\./)+)$technique/|\blanthorn::$technique\b" gi_module --include='*.'{h,cpp,glsl,comp,vert,frag} --include=CMakeLists.txt |
        grep -vE "^gi_module/($technique/|techniques/|technique\.cpp:)") || true
    [ -z "$found" ] || { echo "gi_module/$technique is another technique's own:"; echo "$found"; status=1; } >&2
done
exit $status
