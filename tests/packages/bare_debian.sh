# Sourced by the checks of archives: a bare Debian of any release below /var/tmp, without compilers, which goes with the script. Needs
# root, mmdebstrap and the network. KEEP=yes leaves it where it is.

# In mounts and processes of its own, all of which end with it.
[[ -n ${COAPT_UNSHARED:-} ]] || COAPT_UNSHARED=yes exec unshare --mount --pid --fork --kill-child "$0" "$@"

say() { printf '\n== %s\n' "$*"; }
fail() { echo "${0##*/}: $*" >&2; exit 1; }

new_root() { root=$(mktemp -d /var/tmp/coapt-bare-XXXXXX); }
new_root
# What is mounted in there is this machine's: unmounted first, and never reached by rm, whoever was killed on the way.
finish() {
  local mounted
  while read -r mounted; do
    umount --lazy "$mounted" || return
  done < <(awk -v root="$root" '$2 == root || index($2, root "/") == 1 { print $2 }' /proc/self/mounts | sort --reverse)
  [[ -n ${KEEP:-} ]] || rm -rf --one-file-system "$root"
}
trap finish EXIT

# Lines of sources.list for a release, from the archives that this machine's apt has for its own.
sources_of() {
  local suite=$1 here
  here=$(. /etc/os-release && echo "$VERSION_CODENAME")
  apt-get indextargets --format "\$(SITE) \$(RELEASE) \$(COMPONENT)" "Created-By: Packages" | sort --unique |
    awk -v here="$here" -v suite="$suite" '$2 ~ "^" here { sub("^" here, suite, $2); print "deb", $1, $2, $3 }'
}

# make_bare SUITE: nothing but what is essential, and apt, which has its lists.
make_bare() {
  sources_of "$1" | mmdebstrap --quiet --mode=root --variant=apt --dpkgopt=force-unsafe-io --skip=cleanup/apt/lists "$1" "$root" -
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount --make-rslave "$root/dev"
  cp --dereference /etc/resolv.conf "$root/etc/resolv.conf"
}

within() {
  chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@"
}

apt_install() {
  within apt-get install -qq -y --no-install-recommends -o Dpkg::Use-Pty=0 "$@" >"$root/tmp/apt.log" 2>&1 || { cat "$root/tmp/apt.log"; return 1; }
}

megabytes() { du --summarize --one-file-system --block-size=1M "$root" | cut -f 1; }

# seconds SINCE UNTIL, both of EPOCHREALTIME
seconds() { awk -v since="$1" -v until="$2" 'BEGIN { printf "%.1f", until - since }'; }
