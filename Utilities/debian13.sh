#!/usr/bin/env bash
# Builds Airlight and runs its tests on Debian 13 with VTK 9.3, in a separate root.
#
# Usage: Utilities/debian13.sh [CTEST OPTION...]
#
# If AIRLIGHT_ROOT is set, it is the folder of the root, which is kept and reused. See bare-root.sh,
# which has to run as root, and test.sh.
set -euo pipefail
if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit
fi
# ParaView's packages miss a library that no dependency installs. Its script editor
# prints a message if pygments is missing.
# shellcheck disable=SC2016 # the inner shell replaces them
exec "$(dirname "${BASH_SOURCE[0]}")/bare-root.sh" --suite trixie \
  ${AIRLIGHT_ROOT:+--root "$AIRLIGHT_ROOT"} bash -c 'apt-get -q update &&
    apt-get -qy install --no-install-recommends libadios2-mpi-c++11-2.10 python3-pygments &&
    exec Utilities/test.sh "$@"' bash "$@"
