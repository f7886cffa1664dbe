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
exec "$(dirname "${BASH_SOURCE[0]}")/bare-root.sh" --suite trixie \
  ${AIRLIGHT_ROOT:+--root "$AIRLIGHT_ROOT"} Utilities/test.sh "$@"
