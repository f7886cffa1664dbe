# shellcheck shell=bash
# Shared by test.sh and demo.sh: source it after `set -euo pipefail`.

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
  echo "[$step_number/$step_count] $*"
}

# install_missing PROGRAM...: installs what is missing where there is apt-get, and stops unless every
# program is there afterwards.
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

# configure [CMAKE OPTION...]: configures build/, keeping what an earlier run has there.
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

# compile TARGET: builds one target in build/, or `all`.
compile()
{
  cmake --build "$build" --parallel "$jobs" --target "$1" ||
    die "the build failed; see the compiler's message above."
}

# on_virtual_display COMMAND...: runs a command under an X server without a screen. -noreset keeps
# the server alive between two windows of one program.
on_virtual_display()
{
  xvfb-run -a -s "-noreset -screen 0 1280x1024x24" "$@"
}
