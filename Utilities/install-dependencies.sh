#!/usr/bin/env bash
# Installs the packages that Airlight needs to build, test and run on Debian 12. Leaves installed
# packages unchanged. Uses sudo if necessary.
#
# Usage: Utilities/install-dependencies.sh [OPTION...]
#
#   --with-openvdb   also install OpenVDB, for reading .vdb files
#   --with-doxygen   also install Doxygen, for the class reference
#   --with-checks    also install cppcheck, shellcheck and pyflakes for static checks, and Git, which
#                    lists the files
#   --with-analysis  the same, and clang-tidy for thorough checks, and gcovr for coverage
#   --with-clang     also install Clang and its sanitizers, for fuzzing
#   --with-wheel     also install what a wheel is built and tested with
set -euo pipefail

packages=(
  # to build
  build-essential cmake ninja-build ccache
  libvtk9-dev libeigen3-dev libglm-dev libcli11-dev nlohmann-json3-dev
  # to measure
  libbenchmark-dev
  # to make packages
  file
  # Python
  python3-vtk9 python3-numpy python3-h5py
  # to render without a screen
  xvfb xauth libgl1-mesa-dri libegl-dev libegl1 libegl-mesa0
)

for option in "$@"; do
  case $option in
    --with-openvdb) packages+=(libopenvdb-dev libboost-iostreams-dev) ;;
    --with-doxygen) packages+=(doxygen) ;;
    --with-checks) packages+=(git cppcheck shellcheck pyflakes3) ;;
    --with-analysis) packages+=(git cppcheck shellcheck pyflakes3 clang-tidy gcovr) ;;
    --with-wheel) packages+=(python3-dev python3-venv chromium) ;;
    --with-clang) packages+=(clang libclang-rt-dev llvm) ;;
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    *)
      echo "error: unknown option '$option'; try --help." >&2
      exit 1
      ;;
  esac
done

command -v apt-get > /dev/null || {
  echo "error: apt-get is missing; this script is for Debian. It would have installed:" >&2
  echo "  ${packages[*]}" >&2
  exit 1
}

as_root=()
if ((EUID != 0)); then
  command -v sudo > /dev/null || {
    echo "error: run this script as root, or install sudo." >&2
    exit 1
  }
  as_root=(sudo)
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2> /dev/null) || status=
  [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "Everything is installed."
  exit
fi

echo "[1/2] Updating the package lists"
"${as_root[@]}" apt-get update
echo "[2/2] Installing ${missing[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --no-install-recommends "${missing[@]}"
