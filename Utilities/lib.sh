# shellcheck shell=bash
# Shared by test.sh and demo.sh: source it after `set -euo pipefail`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
jobs=${AIRLIGHT_JOBS:-$(nproc)}
step_number=0
step_count=0 # set by the script

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

# need PROGRAM...: stops unless every program is installed.
need()
{
  local program
  for program in "$@"; do
    command -v "$program" > /dev/null ||
      die "'$program' is missing. On Debian, run Utilities/install-dependencies.sh first."
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
    die "CMake could not configure the build; see its message above. On Debian," \
      "Utilities/install-dependencies.sh installs what it needs."
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
