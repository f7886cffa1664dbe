#!/usr/bin/env bash
# Runs a command of this repository in a fresh Debian base system and reports how long it took. Use it
# to test a newcomer's steps and other releases of Debian. Needs root, debootstrap and 6 GB. It changes
# nothing outside the folder of the root.
#
# Usage: Utilities/bare-root.sh [--suite NAME] [--root DIR] [--mirror URL] [--copy DIR] [COMMAND...]
#
#   --suite    the release: bookworm (Debian 12, the default), trixie (Debian 13)
#   --root     the folder of the root; it is kept and reused. Default: a temporary folder, which is
#              removed at the end
#   --mirror   the mirror of Debian's packages. Default: the mirror that apt uses on this machine
#   --copy     a folder that is copied into the clone, under its own name
#   COMMAND    runs in a clone of the last commit. Default: Utilities/demo.sh --no-view, which renders
#              Figure 1
#
# AIRLIGHT_JOBS is the number of parallel jobs, as in the other scripts. If PIP_CERT names a file of
# certificates, as on machines behind a proxy, pip uses it in the root, too.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
step_count=3

suite=bookworm
folder=
mirror=
copied=
while (($#)); do
  case $1 in
    --suite | --root | --mirror | --copy)
      (($# >= 2)) || die "$1 needs a value."
      case $1 in
        --suite) suite=$2 ;;
        --root) folder=$2 ;;
        --mirror) mirror=$2 ;;
        --copy) copied=$(realpath "$2") ;;
      esac
      shift 2
      ;;
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    -*) die "unknown option '$1'; try --help." ;;
    *) break ;;
  esac
done
command=("$@")
(($#)) || command=(Utilities/demo.sh --no-view)

((EUID == 0)) || die "this script has to be run as root: it makes a root file system."
command -v debootstrap > /dev/null || die "debootstrap is missing; install it first."
command -v git > /dev/null || die "git is missing; install it first."
if [[ -z $mirror ]]; then
  # shellcheck disable=SC2016 # apt replaces it
  mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Component: main' |
    sed -n '/\/debian\/\{0,1\}$/{p;q}')
  [[ -n $mirror ]] || die "apt knows no mirror of Debian here; name one by --mirror."
fi
if [[ -z $folder ]]; then
  folder=$(mktemp -d)
  chmod 755 "$folder"
  trap 'rm -rf --one-file-system "$folder"' EXIT
fi

step "Making a root of $suite in $folder"
if [[ ! -e $folder/airlight-root-complete ]]; then
  debootstrap --variant=minbase "$suite" "$folder" "$mirror" > "$folder.debootstrap.log" 2>&1 ||
    die "debootstrap failed; see $folder.debootstrap.log"
  touch "$folder/airlight-root-complete"
fi
rm -f "$folder.debootstrap.log"
cp --dereference /etc/resolv.conf /etc/hosts "$folder/etc/"
settings=()
if [[ -n ${PIP_CERT:-} ]]; then
  cp --dereference "$PIP_CERT" "$folder/etc/pip-certificates.crt"
  settings=(PIP_CERT=/etc/pip-certificates.crt)
fi

step "Cloning"
start=$SECONDS
TIMEFORMAT='%0R s by the clock; processors: %0U s in programs, %0S s in the system'
rm -rf "$folder/root/airlight"
time git clone --quiet "file://$root" "$folder/root/airlight"
[[ -z $copied ]] || cp -r "$copied" "$folder/root/airlight/" || die "'$copied' could not be copied."

# In a separate mount namespace, whose mounts disappear when it ends.
step "Running ${command[*]}"
result=0
# shellcheck disable=SC2016 # the inner shell replaces them
time unshare --mount --pid --fork --kill-child bash -c '
  set -e
  mount -t proc proc "$0/proc"
  mount --rbind /dev "$0/dev"
  mount -t tmpfs tmpfs "$0/tmp"
  exec chroot "$0" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
    "$@"
' "$folder" AIRLIGHT_JOBS="$jobs" "${settings[@]}" \
  bash -c 'cd /root/airlight && exec "$@"' bash "${command[@]}" || result=$?
echo "$suite: ${command[*]}: $((SECONDS - start)) s from the clone on, with $jobs jobs, exit $result"
exit "$result"
