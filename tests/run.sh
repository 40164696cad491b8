#!/bin/sh
# Builds everything and proves the numbers: see the README.
# The second build, with the address and undefined-behaviour sanitizers, runs the same tests.
set -eu
cd "$(dirname "$0")/.."
. demo/packages.sh
install_packages $demo_packages libgtest-dev libcsv-dev libbenchmark-dev glslang-tools libvulkan-dev mesa-vulkan-drivers gnuplot-nox python3-venv xvfb xdotool

cmake -S . -B build/tests -DCMAKE_BUILD_TYPE=Release -DNACRE_WARNINGS_AS_ERRORS=ON
cmake --build build/tests --parallel "$(nproc)"
ctest --test-dir build/tests --parallel "$(nproc)" --output-on-failure --no-tests=error

cmake -S . -B build/sanitize -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O1 -g1" -DNACRE_WARNINGS_AS_ERRORS=ON -DNACRE_SANITIZE=ON
cmake --build build/sanitize --parallel "$(nproc)"
ctest --test-dir build/sanitize --parallel "$(nproc)" --output-on-failure --no-tests=error
