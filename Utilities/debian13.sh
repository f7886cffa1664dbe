#!/usr/bin/env bash
# Builds Airlight and passes its tests on Debian 13 with VTK 9.3, in a root of its own.
#
# Usage: Utilities/debian13.sh [CTEST OPTION...]
#
# AIRLIGHT_ROOT is the folder of the root, which is then kept and used again. See bare-root.sh, which
# needs to be run as root, and test.sh.
set -euo pipefail
if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit
fi
# ParaView's packages there lack a library that nothing else brings.
# shellcheck disable=SC2016 # the inner shell replaces them
exec "$(dirname "${BASH_SOURCE[0]}")/bare-root.sh" --suite trixie \
  ${AIRLIGHT_ROOT:+--root "$AIRLIGHT_ROOT"} bash -c 'apt-get -q update &&
    apt-get -qy install --no-install-recommends libadios2-mpi-c++11-2.10 &&
    exec Utilities/test.sh "$@"' bash "$@"
