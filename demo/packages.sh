# Sourced by the run scripts: installs those of the named Debian packages that are missing.
install_packages() {
    missing=
    for package in "$@"; do
        dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing="$missing $package"
    done
    [ -n "$missing" ] || return 0
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "these Debian packages are missing, install them as root:$missing" >&2; return 1; }
        as_root=sudo
    fi
    echo "Installing$missing"
    $as_root apt-get update -qq
    # shellcheck disable=SC2086  # a list of words
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
}

# A compiler, CMake, and what nacre-render and nacre-view are built on. OpenImageIO's package config asks for its tools.
demo_packages="g++ make cmake libglm-dev libegl-dev libgl-dev libosmesa6 libegl1 libgl1-mesa-dri libtinygltf-dev
nlohmann-json3-dev libopenimageio-dev openimageio-tools libcli11-dev libboost-dev fonts-dejavu-core
libglfw3-dev libimgui-dev libgl1"
