#!/usr/bin/env bash
# Installs what is missing, builds the benchmarks in build/ and packs them with their libraries into
# one file, for a machine with a graphics card that has only its driver and a glibc at least as new as
# this machine's (Debian 12, Ubuntu 24.04 or newer). Run there:
#
#   tar xf airlight-benchmark.tar.gz && airlight-benchmark/run.sh
#
# Usage: Utilities/benchmark-package.sh [-o FILE]     default: airlight-benchmark.tar.gz
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=4

output=airlight-benchmark.tar.gz
while (($#)); do
  case $1 in
    -o)
      (($# >= 2)) || die "-o needs a file."
      output=$2
      shift
      ;;
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    *) die "unknown option '$1'; try --help." ;;
  esac
  shift
done
folder=$(dirname "$output")
[[ -d $folder && -w $folder ]] || die "cannot write '$output'."

programs=(AirlightBenchmarkFrames AirlightBenchmarkSilhouette)

# list_libraries PROGRAM...: name and path of each library that the programs load.
list_libraries()
{
  ldd "$@" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }' | sort -u
}

# copy_licence LIBRARY FOLDER: the licence of the Debian package that contains a library.
copy_licence()
{
  local path package
  path=$(readlink -f "$1")
  package=$(dpkg-query --search "$path" 2> /dev/null ||
    dpkg-query --search "${path#/usr}" 2> /dev/null) || return 0
  package=${package%%:*}
  [[ ! -e /usr/share/doc/$package/copyright ]] ||
    cp -L "/usr/share/doc/$package/copyright" "$2/$package"
}

step "Installing what is missing"
install_missing cmake c++

step "Configuring"
configure -DAIRLIGHT_BUILD_TESTING=ON

step "Building"
compile benchmarks

step "Packing"
temporary=$(mktemp -d)
trap 'rm -rf "$temporary"' EXIT
package=$temporary/airlight-benchmark
mkdir -p "$package"/{bin,lib,spare,licences}
cp "$root/Utilities/benchmark-run.sh" "$package/run.sh"
cp "$root/LICENSE" "$package/licences/airlight"
cp "${programs[@]/#/$build/bin/}" "$package/bin/"
missing=$(ldd "$package"/bin/* | grep 'not found' || true)
[[ -z $missing ]] || die "libraries of the benchmarks are missing:" "$missing"

while read -r name path; do
  case $name in
    # part of every system
    ld-linux* | libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | libresolv.so.*)
      continue
      ;;
    # drivers load these, too: prefer the machine's own
    libGL* | libEGL* | libOpenGL* | libX* | libxcb* | libbsd* | libmd.* | libstdc++* | libgcc_s* | \
      libz.so* | libzstd* | liblzma*)
      [[ $name == libGLEW* ]] && target=lib || target=spare
      ;;
    *) target=lib ;;
  esac
  cp -L "$path" "$package/$target/$name"
  copy_licence "$path" "$package/licences"
done < <(list_libraries "${programs[@]/#/$build/bin/}")

tar -C "$temporary" -czf "$output" airlight-benchmark
echo "Done: $(realpath "$output"), $(du -h "$output" | cut -f 1)"
