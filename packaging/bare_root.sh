#!/usr/bin/env bash
# Makes a folder that holds a bare Debian: what is essential, and what the given packages depend on, and nothing else, taken from the
# packages that are installed on this machine (no network is needed). A dependency that a package does not name is missing there.
# Needs to be root, or root of a user namespace.   packaging/bare_root.sh ROOT PACKAGE.deb ...
set -euo pipefail
mkdir -p "$1"
root=$(cd "$1" && pwd)
shift

# Names of the packages: a walk over Depends and Pre-Depends, of alternatives the first that is installed. What is not installed at all
# is left out, so that dpkg complains.
wanted=$(for package in "$@"; do
    dpkg-deb -f "$package" Depends
    dpkg-deb -f "$package" Pre-Depends
done | tr '\n' ',')
names=$(dpkg-query -W -f='${db:Status-Status}\t${Package}\t${Essential}\t${Depends}, ${Pre-Depends}\t${Provides}\n' |
    awk -F '\t' -v wanted="$wanted" '
    function bare(text) { gsub(/\([^)]*\)|:[a-z0-9]+|[ \t]/, "", text); return text }
    $1 == "installed" {
        depends[$2] = depends[$2] "," $4
        count = split(bare($5), list, ",")
        for (i = 1; i <= count; ++i) if (list[i] != "" && !(list[i] in provider)) provider[list[i]] = $2
        if ($3 == "yes") queue[++last] = $2
    }
    function want(text,    groups, n, i, choices, m, j) {
        n = split(bare(text), groups, ",")
        for (i = 1; i <= n; ++i) {
            m = split(groups[i], choices, "|")
            for (j = 1; j <= m; ++j) {
                if (choices[j] in depends) { queue[++last] = choices[j]; break }
                if (choices[j] in provider) { queue[++last] = provider[choices[j]]; break }
            }
        }
    }
    END {
        want(wanted)
        for (first = 1; first <= last; ++first) {
            if (queue[first] in seen) continue
            seen[queue[first]] = 1
            print queue[first]
            want(depends[queue[first]])
        }
    }')

# Their files, linked where that is possible; configuration is copied, for it may be changed.
for folder in bin sbin lib lib32 lib64 libx32; do
    [ ! -L /$folder ] || ln -s "$(readlink /$folder)" "$root/$folder"
done
mkdir -p "$root"/{dev,etc/alternatives,proc,root,run,sys,tmp,usr/bin,usr/sbin,usr/lib,usr/lib64,var/log,var/lib/dpkg/info,var/lib/dpkg/updates,var/tmp}
# shellcheck disable=SC2086
dpkg -L $names | sed -E 's,^/(bin|sbin|lib[0-9x]*)/,/usr&,' | sort -u | while IFS= read -r file; do
    if { [ -L "$file" ] || [ -f "$file" ]; } && [[ $file != /usr/share/doc/* && $file != /usr/share/locale/* ]]; then
        printf '%s\0' "${file#/}"
    fi
done > "$root/files"
(
    cd /
    grep -zv '^etc/' "$root/files" | xargs -0 cp -l -d --parents --preserve=mode,links -t "$root" 2> /dev/null ||
        grep -zv '^etc/' "$root/files" | xargs -0 cp -d --parents --preserve=mode,links --remove-destination -t "$root"
    { grep -z '^etc/' "$root/files" || true; } | xargs -0 -r cp -d --parents --preserve=mode,links -t "$root"
)
rm "$root/files"

# What maintainer scripts have made: alternatives, accounts, the loader's cache.
for alternative in /var/lib/dpkg/alternatives/*; do
    name=$(basename "$alternative")
    link=$(sed -n 2p "$alternative")
    if [ -L "$link" ] && [ -e "$root$(readlink "/etc/alternatives/$name")" ]; then
        cp -d "/etc/alternatives/$name" "$root/etc/alternatives/"
        mkdir -p "$root$(dirname "$link")"
        cp -d "$link" "$root$link"
    fi
done
cp /usr/share/base-passwd/passwd.master "$root/etc/passwd"
cp /usr/share/base-passwd/group.master "$root/etc/group"
awk -v names="$names" 'BEGIN { RS = ""; ORS = "\n\n"; split(names, list, "\n"); for (i in list) wanted[list[i]] = 1 }
    { split($0, lines, "\n"); if (substr(lines[1], 10) in wanted) print }' /var/lib/dpkg/status > "$root/var/lib/dpkg/status"
for name in $names; do
    for list in "/var/lib/dpkg/info/$name.list" "/var/lib/dpkg/info/$name":*.list; do
        [ ! -f "$list" ] || cp "$list" "$root/var/lib/dpkg/info/"
    done
done
ldconfig -r "$root"

mkdir "$root/packages"
cp "$@" "$root/packages"
chroot "$root" sh -c 'PATH=/usr/sbin:/usr/bin dpkg --install /packages/*.deb' > "$root/dpkg.log" 2>&1 || {
    cat "$root/dpkg.log" >&2
    exit 1
}
