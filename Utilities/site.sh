#!/usr/bin/env bash
# Builds the documentation site: the pages of Documentation/, a gallery made by running the examples,
# the Python package from its stubs, and the C++ reference. Then checks its links.
#
# Usage: Utilities/site.sh [--output DIR] [--python PYTHON] [--external] [--quick] [--test]
#
#   --output     the folder of the site, which is replaced. Default: build/site/html
#   --python     a Python that has Airlight: its Airlight is used. Default: the newest wheel in dist/,
#                or else the wheel that is installed for python3
#   --external   also fetches links to other sites; otherwise they are listed
#   --quick      runs no examples: a site without their pictures, to find broken links and warnings
#   --test       also runs Testing/Site on the result, which needs Chromium and its driver
#
# Needs CMake and Doxygen, and the packages of Documentation/site/requirements.txt, which it installs
# into a virtual environment, build/site-venv. Warnings are errors. The results of examples are kept in
# build/site/examples until the example or the package changes.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=5

work=$build/site
output=$work/html
python=
external=()
with_test=0
pictures=(--pictures "$work/examples")
while (($#)); do
  case $1 in
    --output | --python)
      (($# >= 2)) || die "$1 needs a value."
      case $1 in
        --output) output=$(realpath -m "$2") ;;
        --python) python=$(command -v "$2") || die "there is no '$2'." ;;
      esac
      shift
      ;;
    --external) external=(--external) ;;
    --quick) pictures=() ;;
    --test) with_test=1 ;;
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    *) die "unknown option '$1'; try --help." ;;
  esac
  shift
done
((!with_test)) || step_count=6
for program in cmake doxygen; do
  command -v "$program" > /dev/null || die "'$program' is missing; install it first."
done

# newest_wheel: the newest wheel in dist/, or nothing.
newest_wheel()
{
  find "$root/dist" -maxdepth 1 -name 'airlight-*.whl' -printf '%T@ %p\n' 2> /dev/null |
    sort -n | sed -n '$s/^[^ ]* //p'
}

# The folders with the packages airlight and vtkmodules of a Python, one a line.
package_folders()
{
  (cd / && "$1" -c '
import importlib.util, pathlib
for name in ("airlight", "vtkmodules", "numpy", "pyvista", "matplotlib"):
    found = importlib.util.find_spec(name)
    if found:
        print(pathlib.Path(found.origin).parents[1])
    elif name in ("airlight", "vtkmodules", "numpy"):
        raise SystemExit(1)' | sort -u)
}

step "Preparing build/site-venv"
venv=$build/site-venv
wheel=
[[ -n $python ]] || wheel=$(newest_wheel)
python=${python:-$(command -v python3)} || die "'python3' is missing; install it first."
[[ -x $venv/bin/pip ]] || "$python" -m venv --clear "$venv" ||
  die "the virtual environment could not be made (Debian: install python3-venv)."
"$venv/bin/pip" -q install --disable-pip-version-check \
  -r "$root/Documentation/site/requirements.txt" || die "the requirements could not be installed."
borrowed=$("$venv/bin/python" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/airlight.pth
rm -f "$borrowed"
if [[ -n $wheel ]]; then
  # A wheel that was built again may have the same version.
  "$venv/bin/pip" -q uninstall --disable-pip-version-check --yes airlight 2> /dev/null || true
  "$venv/bin/pip" -q install --disable-pip-version-check "${wheel}[pyvista]" ||
    die "the wheel $wheel could not be installed."
else
  package_folders "$python" > "$borrowed" || {
    rm -f "$borrowed"
    die "$python has no Airlight, and dist/ no wheel: make one with Utilities/wheel.sh."
  }
fi
unset PYTHONPATH # it comes before the environment's packages
version=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")
installed=$(cd / && "$venv/bin/python" -c 'import airlight; print(airlight.__version__)') ||
  die "the package airlight does not load; see Python's message above."
[[ $installed == "$version" ]] ||
  echo "note: the sources are Airlight $version, the installed package is $installed." >&2

step "Making the C++ reference"
cmake -DAirlight_VERSION="$version" -DAIRLIGHT_REFERENCE_DIR="$work/reference" \
  -P "$root/CMake/AirlightReference.cmake" || die "Doxygen has findings; see above."

step "Preparing the pages${pictures:+, with what the examples draw}"
(cd / && "$venv/bin/python" "$root/Documentation/site/prepare.py" "$work/source" \
  "${pictures[@]}" --doxygen "$work/reference/html") ||
  die "the pages could not be prepared; see the message above."

step "Building the site"
rm -rf "$work/new"
AIRLIGHT_VERSION=$version "$venv/bin/sphinx-build" -W --keep-going -q -j "$jobs" -b html \
  -d "$work/doctrees" "$work/source" "$work/new" || die "Sphinx warns; see above."
mkdir -p "$(dirname "$output")"
rm -rf "$output"
mv "$work/new" "$output"

step "Checking links"
"$venv/bin/python" "$root/Documentation/site/links.py" "$output" "${external[@]}" ||
  die "there are broken links; see above."

if ((with_test)); then
  step "Testing the site"
  AIRLIGHT_SITE=$output "$venv/bin/python" -m pytest -q -p no:cacheprovider "$root/Testing/Site" ||
    die "the site has faults; see above."
fi
echo "Done: $output/index.html"
