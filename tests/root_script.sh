#!/bin/bash
# The root script, in a small copy of the project with stand-ins for the tools it calls.
# shellcheck disable=SC2317 # the functions are called through expect
# shellcheck disable=SC2016 # the stand-ins expand their own variables
set -euo pipefail

source_root=$(cd "$(dirname "$0")/.." && pwd)
box=$(mktemp -d)
trap 'rm -rf "$box"' EXIT
calls=$box/calls # what was called, one a line
failures=0

expect() { # what, then a command that must succeed
    if ! "${@:2}"; then
        echo "FAILED: $1"
        failures=$((failures + 1))
    fi
}
called() { grep -q -- "$1" "$calls"; }
not_called() { ! called "$1"; }
count_is() { [[ $(grep -c -- "$1" "$calls") -eq $2 ]]; }
says() { grep -q -- "$1" "$box/said"; }

tool() { # a stand-in: name, then its body
    printf '#!/bin/bash\necho "%s $*" >>"%s"\n%s\n' "$1" "$calls" "$2" >"$box/bin/$1"
    chmod +x "$box/bin/$1"
}

fresh() { # a project with nothing built, on a machine where everything is in place
    rm -rf "${box:?}"/*
    mkdir -p "$box/bin" "$box/elsewhere" "$box"/root/{app,cmake,config,field,render,synth,tests}
    touch "$calls" "$box"/root/{CMakeLists.txt,CMakePresets.json,app/main.cpp}
    cp "$source_root/cydonia" "$box/root/"
    printf '# a comment\ncmake\npovray\n' >"$box/root/packages.txt"
    printf '# a comment\ngtest\n' >"$box/root/packages-test.txt"
    tool dpkg-query 'printf "installed cmake\ninstalled povray\ninstalled gtest\n"'
    tool apt-get 'echo "pmstatus:povray:50.0:Unpacking"'
    tool id 'echo 0'
    tool ctest ''
    tool cmake 'case $1 in --build)
        echo "[1/2] Building"
        sleep "${BUILD_SECONDS-0}"
        mkdir -p build/release/app
        printf "#!/bin/sh\necho in \$PWD: \"\$@\"\nexit 3\n" >build/release/app/cydonia
        chmod +x build/release/app/cydonia
        echo "[2/2] Linking"
    esac'
}

cydonia() { # from another folder; output goes to "said", its exit code to "code"
    code=0
    (cd "$box/elsewhere" && PATH=$box/bin:$PATH "$box/root/cydonia" "$@") \
        >"$box/said" 2>&1 </dev/null || code=$?
}

fresh
cydonia render 'a scene.toml' --quiet
expect "becomes the program, in the same folder, with the same arguments" \
    says "in $box/elsewhere: render a scene.toml --quiet"
expect "passes the program's exit code on" [ "$code" = 3 ]
expect "says how far it is" says "building, 50%"
expect "builds the program only" called "cmake --build --preset release --target cydonia"
expect "installs nothing when nothing is missing" not_called apt-get

cydonia info
expect "does not build again" count_is "cmake --build" 1
expect "does not even look for packages again" count_is "dpkg-query" 1
expect "says nothing of its own" [ "$(cat "$box/said")" = "in $box/elsewhere: info" ]

sleep 0.01
touch "$box/root/app/main.cpp"
CYDONIA_NO_BUILD=1 cydonia info
expect "builds nothing when told so" count_is "cmake --build" 1
cydonia info
expect "builds again after an edit" count_is "cmake --build" 2

cydonia test -R cache
expect "test builds everything" called "--target all"
expect "test passes options on to ctest" called "ctest --test-dir .* -R cache"
cydonia info
expect "after test the program is built" count_is "cmake --build" 3

fresh
tool dpkg-query 'printf "installed cmake\nconfig-files povray\n"; exit 1'
cydonia info
expect "root installs what is missing, and only that" \
    called "apt-get install --yes --no-install-recommends povray "
expect "shows apt's progress" says "installing, 75%"

fresh
tool dpkg-query 'printf "installed cmake\ninstalled povray\n"'
cydonia info
expect "packages of the tests are not needed to run" not_called "apt-get install"
cydonia test
expect "test installs its own packages" called "apt-get install .* gtest "
expect "test configures the tests" called "cmake --preset release -DCYDONIA_TESTS=ON"

fresh
mkdir -p "$box/root/config/exemplars" "$box/deb/texturesurface"
echo heights >"$box/deb/texturesurface/topography.png"
tool apt-get 'touch qtdatavisualization5-examples_1_all.deb'
tool dpkg-deb "tar -C '$box' -c ./deb"
cydonia info
expect "takes the one file that it needs out of a package" \
    grep -q heights "$box/root/config/exemplars/topography.png"
expect "does not install that package" not_called "apt-get install"

fresh
mkdir -p "$box/root/config/exemplars"
tool apt-get 'exit 100'
tool dpkg-deb ''
cydonia info
expect "goes on without it" [ "$code" = 3 ]
expect "says that it is missing" says "could not fetch the elevation model"
expect "leaves nothing half-written" [ ! -e "$box/root/config/exemplars/topography.png" ]

fresh
tool dpkg-query 'printf "installed cmake\n"'
tool id 'echo 1000'
tool sudo ''
cydonia info
expect "without a terminal it prints the one command" \
    says "apt-get install --yes --no-install-recommends povray"
expect "fails then" [ "$code" = 1 ]
expect "never calls sudo unasked" not_called sudo
expect "does not build then" not_called "^cmake"

fresh
tool apt-get 'echo "E: Unable to locate package povray" >&2; exit 100'
tool dpkg-query 'printf "installed cmake\n"'
cydonia info
expect "shows why packages could not be installed" says "Unable to locate package"
expect "fails when they could not" [ "$code" = 1 ]

fresh
tool cmake 'echo "FAILED: main.o"; echo "main.cpp:1: error: no"; exit 1'
cydonia info
expect "shows the compiler's error" says "error: no"
expect "fails when the build fails" [ "$code" = 1 ]

fresh
CYDONIA_NO_BUILD=1 cydonia info
expect "has nothing to run" says "nothing is built yet"

fresh
export BUILD_SECONDS=1
(cydonia one) &
(cydonia two) &
wait
expect "two at once build once" count_is "cmake --build" 1

[[ $failures -eq 0 ]] && echo "the root script does all that it promises"
exit "$failures"
