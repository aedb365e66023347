#!/usr/bin/env bash
# Installs the packages lanthorn, lamplighter and lanthorn-data of FOLDER into a bare Debian (bare_root.sh) and runs them there, without
# source tree, build tree or network: a picture, and pictures of the game.
#
#   packaging/try_packages.sh FOLDER
#
# Exit codes: 0 it runs, 1 it does not, 77 this machine cannot make such a root (the reason is printed).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(cd "$1" && pwd)

skip() {
    printf 'skipped: %s\n' "$*"
    exit 77
}
for tool in dpkg-query ldconfig unshare chroot; do
    PATH=$PATH:/usr/sbin:/sbin command -v "$tool" > /dev/null || skip "found no $tool"
done
# What is done below: namespaces, and a mount in them.
can_mount() {
    unshare "$@" --mount --pid --fork sh -c 'mount -t proc proc /proc' 2> /dev/null
}
as_root=()
if [ "$(id -u)" -ne 0 ]; then
    can_mount --map-root-user ||
        skip "needs to be root, or a system that lets users make namespaces of their own"
    as_root=(--map-root-user)
fi
can_mount "${as_root[@]}" || skip "this machine (a container?) does not let root mount anything"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/inside" << 'EOF'
set -e
export PATH=/usr/bin:/usr/games HOME=/root LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
cd /tmp
lanthorn --version
lanthorn render /usr/share/lanthorn/assets/cornell.glb --size 64x48 --preset low -o box.png
lanthorn render --list-settings > settings
grep -q gi.emc.count settings
lamplighter --headless --frames 1 --size 64x36 --preset low --out pictures
test "$(ls pictures/*.png | wc -l)" -ge 1
lamplighter --headless --level /usr/share/lanthorn/assets/levels/red-wall.glb
test -s box.png
EOF
cat > "$work/outside" << 'EOF'
set -e
PATH=$PATH:/usr/sbin:/sbin
here=$1 folder=$2 work=$3
"$here/bare_root.sh" "$work/root" "$folder"/lanthorn_*.deb "$folder"/lamplighter_*.deb "$folder"/lanthorn-data_*.deb
mount -t proc proc "$work/root/proc"
mount --rbind /dev "$work/root/dev"
cp "$work/inside" "$work/root/inside"
exec chroot "$work/root" /bin/sh /inside
EOF
code=0
unshare "${as_root[@]}" --mount --pid --fork bash "$work/outside" "$here" "$folder" "$work" || code=$?
if [ $code -eq 0 ]; then
    echo "lanthorn and lamplighter run where nothing else is installed"
    exit 0
fi
echo "ended with $code in the bare root" >&2
exit 1
