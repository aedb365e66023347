# What tools/play and tools/test have in common; sourced by them. All set-up on a bare Debian 12, and nothing where
# everything is there already.
#
#   lanthorn_install_packages          the packages of tools/packages.txt
#   lanthorn_build PRESET [TARGETS]    configure and build into build/PRESET; a folder that it makes compiles sources in batches
#                                      (LANTHORN_UNITY=OFF: one by one)

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '== %s\n' "$*" >&2; }
fail() {
    printf '%s: %s\n' "$(basename "$0")" "$*" >&2
    exit 2
}

# Names of packages of the list that are not installed, one a line.
lanthorn_missing_packages() {
    local wanted installed
    wanted=$(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$root/tools/packages.txt" | sort -u)
    # dpkg-query fails when it does not know one of the names; what it does know it still prints.
    # shellcheck disable=SC2086
    installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p' | sort -u) || true
    comm -23 <(echo "$wanted") <(echo "$installed")
}

lanthorn_install_packages() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "no dpkg here: expecting what tools/packages.txt lists to be installed already"
        return
    fi
    local missing
    mapfile -t missing < <(lanthorn_missing_packages)
    if [ ${#missing[@]} -eq 0 ]; then
        return
    fi
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null ||
            fail "packages are missing (${missing[*]}); installing them needs root, or sudo, which is missing too"
        as_root=(sudo)
    fi
    say "installing ${#missing[@]} packages: ${missing[*]}"
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300)
    "${apt[@]}" update >&2 || fail "apt-get update failed; these packages are missing: ${missing[*]}"
    "${apt[@]}" install --no-install-recommends "${missing[@]}" >&2 ||
        fail "apt-get could not install all of: ${missing[*]}"
    mapfile -t missing < <(lanthorn_missing_packages)
    [ ${#missing[@]} -eq 0 ] || fail "still missing after apt-get install: ${missing[*]}"
}

lanthorn_build() {
    local preset=$1 target=${2:-all}
    local folder=$root/build/$preset
    if [ ! -f "$folder/build.ninja" ]; then
        say "configuring build/$preset"
        (cd "$root" && cmake --preset "$preset" -DLANTHORN_UNITY="${LANTHORN_UNITY:-ON}") >&2 || fail "configuring preset '$preset' failed (see above)"
    fi
    say "building build/$preset ($target)"
    # shellcheck disable=SC2086
    cmake --build "$folder" --target $target >&2 || fail "building preset '$preset' failed (see above)"
}
