#!/usr/bin/env bash
# A technique is a folder of its own: neither another technique nor what techniques share nor the door includes anything of it,
# C++ or shaders, or links it. The lists of techniques in gi_module/techniques alone name them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
status=0
techniques=(gi_module/techniques/*/*_technique.cpp)
[ ${#techniques[@]} -ge 5 ] || { echo "gi_module/techniques/*/*_technique.cpp: found ${#techniques[@]}, expected every technique's" >&2; exit 1; }
for technique in "${techniques[@]}"; do
    technique=$(basename "$(dirname "$technique")")
    # A path in an #include, one that a program is made of, or a library in a build file.
    found=$(grep -rnE "\"(lanthorn/|gi_module/techniques/|(\.\./)+)$technique/|\blanthorn::$technique([ )]|\$)" gi_module --include='*.'{h,cpp,glsl,comp,vert,frag} --include=CMakeLists.txt |
        grep -vE "^gi_module/techniques/($technique/|[^/]*:)") || true
    [ -z "$found" ] || { echo "gi_module/techniques/$technique is another technique's own:"; echo "$found"; status=1; } >&2
done
exit $status
