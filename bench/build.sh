#!/bin/bash
# What a newcomer waits for: bench/build.sh [packages]
# Prints seconds of the first command in a clean clone of HEAD, of a run after one changed file, and, as root with
# debootstrap, how many packages a bare Debian 12 needs. With "packages" only these. Needs nothing else to run.
set -euo pipefail
cd "$(dirname "$0")/.."
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT

row() { printf '%-58s %10s %12s\n' "$@"; }

seconds_of() { # a command's wall time
    local begin end
    begin=$(date +%s.%N)
    "$@" >"$box/output" 2>&1 || {
        tail -n 20 "$box/output" >&2
        exit 1
    }
    end=$(date +%s.%N)
    echo "$begin $end" | awk '{printf "%.1f", $2 - $1}'
}

after_a_change_of() { # a file: one declaration more at its end
    echo "namespace cydonia { struct Changed$RANDOM; }" >>"$box/clone/$1"
    row "$1 changed, the program runs again" "$(seconds_of "$box/clone/cydonia" --version) s" "$2"
}

packages() { # the name of a list, the files
    local options=(-o "Dir::State::status=$box/root/var/lib/dpkg/status" -o Debug::NoLocking=1
        -o "Dir::Cache::archives=$box/archives/")
    mkdir -p "$box/archives/partial"
    # shellcheck disable=SC2046 # one word a package
    apt-get "${options[@]}" install --print-uris --yes --no-install-recommends \
        $(grep -hv '^#' "${@:3}") |
        awk -v name="$1" -v goal="$2" "/^'/ {n++; bytes += \$3} END {
            printf \"%-58s %10s %12s\n\", name, n \", \" int(bytes / 1e6 + 0.5) \" MB\", goal}"
}

row "what" "reached" "goal"
if [[ ${1-} != packages ]]; then
    git clone --quiet . "$box/clone"
    export CMAKE_CXX_COMPILER_LAUNCHER=
    row "./cydonia --version in a clean clone" "$(seconds_of "$box/clone/cydonia" --version) s" "240 s"
    after_a_change_of synth/sketch/stroke.cpp "15 s"
    after_a_change_of app/pipeline/ledger.cpp "15 s"
    after_a_change_of field/field.h "90 s"
fi
if command -v debootstrap >/dev/null && [[ $(id -u) -eq 0 ]]; then
    debootstrap --variant=minbase bookworm "$box/root" >"$box/output" 2>&1
    packages "packages to run, on a bare Debian 12 (minbase)" "500, 350 MB" packages.txt
    packages "packages to run and test" "" packages.txt packages-test.txt
else
    echo "packages: not counted (needs root and debootstrap)"
fi
