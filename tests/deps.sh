#!/bin/sh
# Installs what `make test` needs besides a C compiler: a C++ compiler, OpenImageIO, Embree; where npm is there, also what opens MaterialX
# files (tests/materialx_open.py), which one test does without otherwise. Does nothing when they are there.
set -u
packages=${MS_PACKAGES:-${HOME:-.}/.cache/ms/npm}
# BABYLON=1: Babylon.js too (110 MB), for tests/babylon.py. esbuild packs three.js into examples/web/three.html.
babylon=""
[ "${BABYLON:-0}" != 1 ] || babylon=babylonjs@9.35.0
[ ! -f "$packages/node_modules/babylonjs/babylon.js" ] || babylon=babylonjs@9.35.0 # npm would remove it
if command -v npm >/dev/null 2>&1 && ! { { [ -z "$babylon" ] || [ -f "$packages/node_modules/babylonjs/babylon.js" ]; } &&
    [ -x "$packages/node_modules/.bin/esbuild" ] && [ -f "$packages/node_modules/three/examples/jsm/loaders/MaterialXLoader.js" ] &&
    [ -f "$packages/node_modules/@needle-tools/materialx/bin/JsMaterialXGenShader.js" ]; }; then
    mkdir -p "$packages" && npm install --prefix "$packages" --ignore-scripts --no-audit --no-fund --no-save --fetch-retries=1 --fetch-timeout=30000 \
        three@0.187.0 @needle-tools/materialx@1.4.6 esbuild@0.25.0 $babylon >/dev/null 2>&1 || echo "deps: npm could not install three.js and MaterialX: their test will be skipped"
fi
root=""
[ "$(id -u)" = 0 ] || root=sudo
if [ "${BLENDER:-0}" = 1 ] && ! command -v blender >/dev/null 2>&1; then # for tests/blender.sh, which is skipped without
    for manager in apt-get dnf zypper pacman; do
        command -v $manager >/dev/null 2>&1 || continue
        case $manager in
        apt-get) $root apt-get update -q && DEBIAN_FRONTEND=noninteractive $root apt-get install -y -q --no-install-recommends blender ;;
        pacman) $root pacman -S --needed --noconfirm blender ;;
        *) $root $manager install -y blender ;;
        esac
        break
    done
    command -v blender >/dev/null 2>&1 || echo "deps: Blender could not be installed: its test will be skipped"
fi
mkdir -p build/deps
probe() { # NAME, then the program's text on standard input, then libraries
    name=$1
    shift
    cat >build/deps/$name.cpp
    ${CXX:-c++} -std=c++17 build/deps/$name.cpp -o build/deps/$name "$@" >build/deps/$name.log 2>&1
}
missing() {
    echo 'int main() { return 0; }' | probe cxx || return 0
    echo '#include <OpenImageIO/imageio.h>
int main() { return OIIO::openimageio_version() == 0; }' | probe oiio -lOpenImageIO -lOpenImageIO_Util || return 0
    { echo '#include <embree4/rtcore.h>
int main() { rtcReleaseDevice(rtcNewDevice(nullptr)); }' | probe embree -lembree4; } ||
    { echo '#include <embree3/rtcore.h>
int main() { rtcReleaseDevice(rtcNewDevice(nullptr)); }' | probe embree -lembree3; } || return 0
    return 1
}
if ! missing; then
    echo "deps: C++ compiler, OpenImageIO and Embree are there"
    exit 0
fi
if command -v apt-get >/dev/null 2>&1; then
    DEBIAN_FRONTEND=noninteractive
    export DEBIAN_FRONTEND
    $root apt-get update -q && $root apt-get install -y -q --no-install-recommends g++ libopenimageio-dev libembree-dev
elif command -v dnf >/dev/null 2>&1; then
    $root dnf install -y gcc-c++ OpenImageIO-devel embree-devel
elif command -v zypper >/dev/null 2>&1; then
    $root zypper --non-interactive install gcc-c++ OpenImageIO-devel embree-devel
elif command -v pacman >/dev/null 2>&1; then
    $root pacman -S --needed --noconfirm gcc openimageio embree
elif command -v apk >/dev/null 2>&1; then
    $root apk add g++ openimageio-dev embree-dev
elif command -v brew >/dev/null 2>&1; then
    brew install openimageio embree
else
    echo "deps: no package manager that this script knows; install a C++17 compiler, OpenImageIO (2.x) and Embree (3 or 4) by hand" >&2
    exit 1
fi
if missing; then
    echo "deps: still missing after the installation; what the compiler said:" >&2
    cat build/deps/*.log >&2
    exit 1
fi
echo "deps: installed"
