#!/usr/bin/env bash
# Tests one kind of a release's files as a user gets them. Utilities/release.sh runs it in a bare root,
# where it installs packages: do not run it elsewhere.
#
# Usage: Utilities/release-check.sh wheel|sdist|deb|source VERSION
#
# The files are in dist/. Each test installs the files, compares the version and renders a picture.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
(($# == 2)) || die "give a kind and a version; see the head of this file."
kind=$1
version=$2
dist=$root/dist
place=$(mktemp -d)
cd "$place" # where no folder gives the package

# add PACKAGE...: installs packages of Debian, or files.
add()
{
  DEBIAN_FRONTEND=noninteractive apt-get install -qq --yes --no-install-recommends "$@" > /dev/null
}

# same WHAT FOUND: compares a version.
same() { [[ $2 == "$version" ]] || die "$1 has version '$2', not $version."; }

# check_picture FILE: a picture in fog takes more room than one of a single colour.
check_picture()
{
  [[ -s $1 ]] || die "there is no picture $1."
  (($(stat -c %s "$1") > 3000)) || die "the picture $1 seems to be empty."
}

# draw_with PYTHON: a picture by the Python package, without a screen.
draw_with()
{
  local python=$1
  same "the Python package" "$("$python" -c 'import airlight; print(airlight.__version__)')"
  "$python" -m airlight > /dev/null
  cat > fog.py << 'EOF'
import airlight
import airlight.display
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer

source = vtkSphereSource()
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(source.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
light = vtkLight()
light.PositionalOn()
light.SetConeAngle(90)
light.SetPosition(1, 1, 0)
renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.AddLight(light)
medium = airlight.vtkParticipatingMedium()
medium.SetVisibility(10)
render_pass = airlight.vtkAirlightPass()
render_pass.SetMedium(medium)
render_pass.RecordBuffersOn()
renderer.SetPass(render_pass)
window = airlight.display.open_window(renderer, offscreen=True)
low, high = render_pass.GetBuffer("Airlight").GetPointData().GetScalars().GetRange(0)
assert 0 < low < high, (low, high)
airlight.display.write_picture(window, "fog.png")
EOF
  "${@:2}" "$python" fog.py
  check_picture fog.png
}

# virtual_environment REQUIREMENT...: in venv, with these packages.
virtual_environment()
{
  python3 -m venv "$place/venv"
  "$place/venv/bin/pip" -q install --disable-pip-version-check "$@"
}

apt-get -qq update
case $kind in
  wheel)
    # A machine with Python and a driver for OpenGL.
    add python3-venv libgl1 libegl1 libgl1-mesa-dri libxrender1
    start=$SECONDS
    virtual_environment "$(compgen -G "$dist/airlight-$version-*.whl")" pyvista
    same "the wheel's metadata" "$("$place/venv/bin/pip" show airlight | sed -n 's/^Version: //p')"
    # The first lines of README.md.
    # shellcheck disable=SC2016 # a code fence
    sed -n '/^```python$/,/^```$/{//!p;/^```$/q}' "$root/README.md" |
      sed 's/pl.show()/pl.show(screenshot="plot.png")/' > plot.py
    PYVISTA_OFF_SCREEN=true VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow \
      "$place/venv/bin/python" plot.py
    check_picture plot.png
    echo "the wheel: $((SECONDS - start)) s from pip install to the picture"
    ;;
  sdist)
    add python3-venv python3-dev build-essential cmake ninja-build libglm-dev libeigen3-dev \
      libgl1 libegl1 libgl1-mesa-dri libxrender1 libgl-dev libegl-dev libx11-dev
    virtual_environment "$dist/airlight-$version.tar.gz"
    draw_with "$place/venv/bin/python" env VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow
    ;;
  deb)
    add "$dist"/*.deb xvfb xauth libgl1-mesa-dri
    same "the program" "$(airlight --version | grep -oE '[0-9]+\.[0-9]+\.[0-9]+' | sed -n 1p)"
    draw_with /usr/bin/python3 on_virtual_display
    on_virtual_display airlight render \
      "$root/Testing/Data/Reference/scenes/S1_point_iso.json" --size 320x240 -o scene.png
    check_picture scene.png
    apt-get remove -qq --yes "libvtkairlight*" python3-airlight airlight > /dev/null
    ! command -v airlight > /dev/null || die "the program is still there after its removal."
    ;;
  source)
    tar -xzf "$dist/airlight-$version-source.tar.gz"
    cd "airlight-$version"
    Utilities/demo.sh --no-view --output "$place"
    check_picture "$place/figure1.png"
    same "the program" "$(build/bin/airlight --version | grep -oE '[0-9]+\.[0-9]+\.[0-9]+' | sed -n 1p)"
    ;;
  *) die "there is no kind '$kind'." ;;
esac
rm -rf "$place"
echo "$kind of $version: works"
