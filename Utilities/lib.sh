# shellcheck shell=bash
# Functions that the scripts share: source it after `set -euo pipefail`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
jobs=${AIRLIGHT_JOBS:-$(nproc)}
step_number=0
step_count=0 # set by the script
dependencies=() # options for install-dependencies.sh, set by the script

die()
{
  echo "error: $*" >&2
  exit 1
}

# step TEXT: announces the next step.
step()
{
  step_number=$((step_number + 1))
  echo "[$step_number/$step_count] $* (after $SECONDS s)"
}

# install_missing PROGRAM...: installs missing packages if there is apt-get, and stops unless every
# program is available afterwards.
install_missing()
{
  if command -v apt-get > /dev/null; then
    "$root/Utilities/install-dependencies.sh" "${dependencies[@]}" ||
      die "the packages could not be installed; see the message above."
  fi
  local program
  for program in "$@"; do
    command -v "$program" > /dev/null ||
      die "'$program' is missing; Utilities/install-dependencies.sh lists all that is needed."
  done
}

# configure [CMAKE OPTION...]: configures build/, and keeps an existing build.
configure()
{
  local generator=()
  if [[ ! -e $build/CMakeCache.txt ]] && command -v ninja > /dev/null; then
    generator=(-G Ninja)
  fi
  cmake -S "$root" -B "$build" "${generator[@]}" "$@" ||
    die "CMake could not configure the build; see its message above." \
      "Utilities/install-dependencies.sh lists the packages that it needs."
}

# compile TARGET...: builds targets in build/, or `all`.
compile()
{
  cmake --build "$build" --parallel "$jobs" --target "$@" ||
    die "the build failed; see the compiler's message above."
}

# on_virtual_display COMMAND...: runs a command under an X server without a screen. -noreset keeps
# the server alive between two windows of one program.
on_virtual_display()
{
  xvfb-run -a -s "-noreset -screen 0 1280x1024x24" "$@"
}

# configure_sanitized KIND [CMAKE OPTION...]: configures $build for sanitizers, KIND address or thread,
# with Clang if available.
configure_sanitized()
{
  local kind=$1 compiler=()
  shift
  if [[ ! -e $build/CMakeCache.txt ]] && command -v clang++ > /dev/null; then
    compiler=(-DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++)
  fi
  configure "${compiler[@]}" -DAIRLIGHT_SANITIZER="$kind" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_C_FLAGS_RELEASE="-O1 -g1" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -g1" "$@"
}

# Suppressions of LeakSanitizer: Utilities/lsan.txt gives the reasons.
leak_options()
{
  echo "suppressions=$root/Utilities/lsan.txt:print_suppressions=0"
}
