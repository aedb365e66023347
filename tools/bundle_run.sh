#!/bin/sh
# Measures the frame rates of Yao et al. 2010, Table 1, on this machine: `run --help` lists what can be chosen, for instance
#   ./run --scene pool --size 1024x1024 --frames 50 --json
# Needs a driver of OpenGL 4.5 and the GNU C library, and 50 MB in TMPDIR (/tmp) while it runs. Exit codes: 0 done, 2 bad usage
# or no room, 3 no usable OpenGL.
set -u

fail() {
    printf 'run: %s\n' "$*" >&2
    exit 2
}

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd -P)
program=$here/bin/lanthorn_bench
unpacked=$(mktemp -d "${TMPDIR:-/tmp}/lanthorn.XXXXXX" 2> /dev/null) || fail "${TMPDIR:-/tmp}: cannot be written"
trap 'rm -rf "$unpacked"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP
for packed in "$here"/lib/*.gz; do
    name=${packed##*/}
    gzip -dc "$packed" 2> /dev/null > "$unpacked/${name%.gz}" || fail "$packed: cannot be unpacked to $unpacked"
done

# The program finds lib/ by itself. Of what the driver may use as well, the machine's own is taken where there is one that will do:
# a driver that is newer than this folder needs a newer one.
libraries=$unpacked${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
LD_LIBRARY_PATH=$libraries "$program" --version > /dev/null 2>&1 || libraries=$libraries:$here/lib/cxx
PATH=${PATH-/usr/bin:/bin}:/sbin:/usr/sbin
if ldconfig -p > /dev/null 2>&1 && ! ldconfig -p | grep -q 'libEGL\.so\.1 '; then
    libraries=$libraries:$here/lib/gl
fi
LD_LIBRARY_PATH=$libraries "$program" bench paper "$@"
