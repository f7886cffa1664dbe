#!/usr/bin/env bash
# Times frames on this machine's graphics card and writes results.md, results.csv and results.json
# into the current folder. This is run.sh of the file that Utilities/benchmark-package.sh makes.
#
# Usage: ./run.sh [OPTION...] [SCENE...]     default: all scenes, 21 frames of each kind, errors
#
# Options are those of bin/AirlightBenchmarkFrames; see ./run.sh --help. The script uses the first of
# these ways to draw that has a graphics card, otherwise, with a warning, the first that works:
#
#   egl      EGL, which needs no X server
#   x        the X server that DISPLAY names
#   nvidia   a virtual X server, with NVIDIA's GLX
#   virtual  a virtual X server
#
# AIRLIGHT_DRAW=WAY selects one way. The last two need xvfb-run. If a driver is in an unusual folder,
# set __EGL_VENDOR_LIBRARY_FILENAMES to its .json for EGL.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$here/bin/AirlightBenchmarkFrames
temporary=$(mktemp -d)
trap 'rm -rf "$temporary"' EXIT

die()
{
  echo "error: $*" >&2
  exit 1
}

# The spare libraries that this machine lacks.
known=$(PATH=$PATH:/sbin:/usr/sbin ldconfig -p | awk '{ print $1 }')
for library in "$here"/spare/*; do
  grep -qxF "$(basename "$library")" <<< "$known" || ln -s "$library" "$temporary/"
done
libraries=$here/lib:$temporary${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}

# draw WAY [OPTION...]: runs the program. No frame waits for a screen.
draw()
{
  local way=$1 start=()
  shift
  case $way in
    egl) set -- --egl "$@" ;;
    nvidia) start=(env __GLX_VENDOR_LIBRARY_NAME=nvidia xvfb-run -a -s "-noreset") ;;
    virtual) start=(xvfb-run -a -s "-noreset") ;;
  esac
  "${start[@]}" env LD_LIBRARY_PATH="$libraries" __GL_SYNC_TO_VBLANK=0 vblank_mode=0 \
    "$program" "$@"
}

if [[ ${1-} == -h || ${1-} == --help ]]; then
  sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  draw egl --help
  exit
fi

ways=(egl x nvidia virtual)
if [[ -n ${AIRLIGHT_DRAW-} ]]; then
  [[ " ${ways[*]} " == *" $AIRLIGHT_DRAW "* ]] ||
    die "AIRLIGHT_DRAW is '$AIRLIGHT_DRAW'; it can be one of: ${ways[*]}."
  ways=("$AIRLIGHT_DRAW")
fi

chosen=
for way in "${ways[@]}"; do
  if info=$(draw "$way" --info 2> "$temporary/messages"); then
    echo "$way: $(sed -n 's/^renderer: //p' <<< "$info")" >&2
    chosen=${chosen:-$way}
    if grep -qx "software: no" <<< "$info"; then
      chosen=$way
      software=no
      break
    fi
  else
    echo "$way: does not work here: $(tail -n 1 "$temporary/messages")" >&2
  fi
done
[[ -n $chosen ]] || die "nothing draws here; the messages above say why."
[[ ${software-yes} == no ]] ||
  echo "warning: no graphics card draws here. These will be the times of a software renderer." >&2

(($#)) || set -- --frames 21 --errors
draw "$chosen" --markdown results.md --csv results.csv --json results.json "$@"
