# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Pendesk authors
# Read by app/run and tests/run: installs what is missing, configures, builds. A second time it takes seconds.

# One line a need; where distributions disagree about a name, the first one that exists is taken.
packages='
g++
cmake
ninja-build
mold
qt6-base-dev
libqt6opengl6-dev
qt6-charts-dev libqt6charts6-dev
libqt6sql6-sqlite
qt6-tools-dev
qt6-tools-dev-tools
qt6-l10n-tools
qt6-translations-l10n
qt6-svg-dev libqt6svg6-dev
qt6-wayland
libexpected-dev libtl-expected-dev
libarchive-dev
libpcap-dev
pkgconf
libsqlite3-dev
fonts-inter
fonts-dejavu-core
'

say() { printf '%s\n' "$*" >&2; }
die() { say "$*"; exit 1; }

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# Prints the needs of which no alternative is installed.
missing_needs() {
    while read -r need; do
        found=
        for package in $need; do
            if is_installed "$package"; then found=yes; fi
        done
        if [ -n "$need" ] && [ -z "$found" ]; then printf '%s\n' "$need"; fi
    done <<EOF
$packages
EOF
}

# Prints the first alternative of a need that this distribution has.
choose() {
    for package in "$@"; do
        if apt-cache show "$package" >/dev/null 2>&1; then
            printf '%s\n' "$package"
            return
        fi
    done
    printf '%s\n' "$1"
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

apt() { as_root env DEBIAN_FRONTEND=noninteractive "$@" -qq -o DPkg::Lock::Timeout=600; }

install_missing() {
    if ! command -v apt-get >/dev/null; then
        say "This system has no apt-get; Pendesk is built with what is installed (see README.md, \"Other systems\")."
        return
    fi
    needs=$(missing_needs)
    if [ -z "$needs" ]; then return; fi
    say "Packages are missing that Pendesk is built with; apt-get installs them."
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        die "That takes root, and there is no sudo: install them as root, then run this again."
    fi
    # What an interrupted run left half installed comes first.
    if [ -n "$(dpkg --audit)" ]; then as_root dpkg --configure -a >&2 || die "dpkg cannot be repaired; see above."; fi
    apt apt-get update >&2 || die "apt-get update failed; see above."
    chosen=$(printf '%s\n' "$needs" | while read -r need; do choose $need; done)
    say "To build and show Pendesk:" $chosen
    apt apt-get install -y --no-install-recommends $chosen >&2 || die "apt-get could not install everything; see above."
}

# Qt wants a folder of this user's own; where nobody logged in there is none.
if [ -z "${XDG_RUNTIME_DIR:-}" ]; then
    mkdir -p -m 700 build/runtime
    XDG_RUNTIME_DIR=$PWD/build/runtime
    export XDG_RUNTIME_DIR
fi

# configure PRESET: the first time, and when the presets changed.
configure() {
    if [ -f "build/$1/build.ninja" ] && [ ! CMakePresets.json -nt "build/$1/build.ninja" ]; then return; fi
    say "Configuring (preset $1)…"
    cmake --preset "$1" >build/configure.log 2>&1 || { cat build/configure.log >&2; die "Configuring failed; see above."; }
    touch "build/$1/build.ninja"
}

# build PRESET [TARGET…]: configures if need be and builds what changed.
build() {
    preset=$1
    shift
    mkdir -p build
    configure "$preset"
    say "Building (preset $preset)…"
    cmake --build --preset "$preset" ${1:+--target "$@"} >&2 || die "The build failed; see above."
}
