#!/bin/sh
# Builds nacre-render and nacre-view and renders the paper's figures: see the README.
# usage: demo/run.sh [MODEL.gltf|MODEL.glb]
set -eu
cd "$(dirname "$0")/.."
. demo/packages.sh
install_packages $demo_packages

cmake -S . -B build/demo -DCMAKE_BUILD_TYPE=Release -DNACRE_TESTS=OFF
cmake --build build/demo --parallel "$(nproc)"
build/demo/demo/nacre-render "$@" --gallery build/gallery --size 512x512
echo "The paper's figures are in $PWD/build/gallery; contact-sheet.png shows them all."
echo "To turn the parameters in a window: build/demo/demo/nacre-view"
