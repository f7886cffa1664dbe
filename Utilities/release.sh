#!/usr/bin/env bash
# Makes what a release consists of, in dist/: sdist, wheel, Debian packages and the source archive of
# the last commit. Tests each in a bare root of Debian, and prints checksums.
#
# Usage: Utilities/release.sh [PART...]
#
#   ready      checks that nothing is uncommitted and that the notes name the version
#   source     makes the source archive
#   wheel      makes sdist and wheel, by Utilities/wheel.sh
#   deb        makes the Debian packages, from build/
#   check      tests all of dist/ in bare roots: see Utilities/release-check.sh
#   check-wheel, check-sdist, check-deb, check-source      test one kind
#   sums       writes dist/SHA256SUMS and prints it
#
# Default: ready, source, wheel, deb, check and sums. The checks need root and debootstrap: see
# Utilities/bare-root.sh. If AIRLIGHT_ROOT is set, it is the folder of the root, which is kept and
# reused; otherwise each check makes a root of its own. AIRLIGHT_SUITE is its release of Debian
# (default: bookworm). AIRLIGHT_JOBS is the number of parallel jobs.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

dist=$root/dist
version=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")
[[ -n $version ]] || die "CMakeLists.txt has no line '  VERSION x.y.z'."

check_ready()
{
  step "Checking that $version is ready"
  [[ -z $(git -C "$root" status --porcelain) ]] ||
    die "there are changes that are not committed; a release is made of a commit."
  "$root/Utilities/check-version.py" || die "there is another version; see above."
  "$root/Utilities/changelog.py" --check || die "the changelog is not up to date."
  grep -qx "## $version" "$root/CHANGELOG.md" ||
    die "no release note is of $version; 'Utilities/changelog.py --release' names it in the new ones."
}

make_source()
{
  step "Making the source archive"
  rm -f "$dist"/airlight-*-source.tar.gz
  git -C "$root" archive --prefix="airlight-$version/" --format=tar.gz \
    -o "$dist/airlight-$version-source.tar.gz" HEAD || die "Git could not make the archive."
}

make_wheel()
{
  step "Making sdist and wheel"
  rm -f "$dist"/airlight-*.whl "$dist"/airlight-[0-9]*[0-9].tar.gz
  "$root/Utilities/wheel.sh" || die "the wheel could not be made; see above."
  compgen -G "$dist/airlight-$version-*.whl" > /dev/null ||
    die "Utilities/wheel.sh left no wheel of $version in dist/."
  [[ -e $dist/airlight-$version.tar.gz ]] ||
    die "Utilities/wheel.sh left no sdist of $version in dist/."
}

make_packages()
{
  step "Making the Debian packages"
  install_missing cmake cpack dpkg-shlibdeps
  configure
  compile all
  rm -rf "$dist"/*.deb "$build/release"
  (cd "$build" && cpack -G DEB -B "$build/release") || die "cpack failed; see above."
  cp "$build"/release/*.deb "$dist/"
  local packages=("$dist"/*_"$version"-*.deb)
  ((${#packages[@]} == 4)) || die "there are ${#packages[@]} packages of $version, not 4."
}

# check KIND: in a bare root.
check()
{
  step "Testing in a bare root: $1"
  "$root/Utilities/bare-root.sh" --suite "${AIRLIGHT_SUITE:-bookworm}" \
    ${AIRLIGHT_ROOT:+--root "$AIRLIGHT_ROOT"} --copy "$dist" \
    Utilities/release-check.sh "$1" "$version" || die "the $1 of the release fails in a bare root."
}

write_sums()
{
  step "Checksums"
  local files
  cd "$dist"
  mapfile -t files < <(find . -maxdepth 1 -type f \
    \( -name '*.whl' -o -name '*.tar.gz' -o -name '*.deb' \) -printf '%f\n' | sort)
  ((${#files[@]})) || die "dist/ has nothing to release."
  local file
  for file in "${files[@]}"; do
    [[ $file == *[-_]"$version"[-.]* ]] || die "dist/$file is not of version $version."
  done
  sha256sum "${files[@]}" | tee SHA256SUMS
}

parts=()
for part in "${@:-all}"; do
  case $part in
    all)
      parts+=(ready source wheel deb check-wheel check-sdist check-deb check-source sums)
      ;;
    check) parts+=(check-wheel check-sdist check-deb check-source) ;;
    ready | source | wheel | deb | sums) parts+=("$part") ;;
    check-wheel | check-sdist | check-deb | check-source) parts+=("$part") ;;
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    *) die "there is no part '$part'; try --help." ;;
  esac
done
step_count=${#parts[@]}
mkdir -p "$dist"
for part in "${parts[@]}"; do
  case $part in
    ready) check_ready ;;
    source) make_source ;;
    wheel) make_wheel ;;
    deb) make_packages ;;
    sums) write_sums ;;
    check-*) check "${part#check-}" ;;
  esac
done
