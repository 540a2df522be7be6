#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The project on another system: makes a bare root of a Debian suite, runs ./test.sh in it, as a new user would, and
# writes a record of what was there and what came of it.
#
#     tests/other_system.sh SUITE [MIRROR]
#
# SUITE: trixie, bookworm, ... ; MIRROR: where its packages are (default: http://deb.debian.org/debian).
# The last commit is tested, not what is changed since. The root stays in build/other/SUITE, and is used again; delete it to
# begin anew. Needs root, and mmdebstrap or debootstrap.
# In the environment: ANEURYSM_OTHER_COMMAND, what to run in place of ./test.sh, in the project's folder.
set -eu
[ $# -ge 1 ] || {
    sed -n 's/^# \{0,1\}//; 3,12p' "$0" >&2
    exit 2
}
suite=$1
mirror=${2:-http://deb.debian.org/debian}
command=${ANEURYSM_OTHER_COMMAND:-./test.sh}
project=$(cd "$(dirname "$0")/.." && pwd)
folder=$project/build/other
root=$folder/$suite
record=$folder/$suite.md
if [ "$(id -u)" -ne 0 ]; then
    echo "other_system.sh: not root; a root of another system can't be made or entered" >&2
    exit 2
fi

if [ ! -e "$root/usr/bin/apt-get" ]; then
    mkdir -p "$root"
    echo "== a bare root of $suite"
    if command -v mmdebstrap >/dev/null; then
        mmdebstrap --quiet --mode=root --variant=minbase "$suite" "$root" "$mirror"
    else
        debootstrap --variant=minbase "$suite" "$root" "$mirror" >/dev/null
    fi
fi
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/other_system" # a root to throw away needs no care for power cuts
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mkdir -p "$folder/ccache" "$root/root/.cache/ccache"
if [ -d "$root/aneurysm/.git" ]; then
    git -C "$root/aneurysm" fetch -q "$project" HEAD
    git -C "$root/aneurysm" checkout -q --force FETCH_HEAD
else
    git clone -q --no-hardlinks "$project" "$root/aneurysm"
fi

# What is mounted goes with the namespace, however this ends.
inside() {
    unshare --mount --pid --fork --kill-child sh -eu -c '
        root=$1
        mount -t proc proc "$root/proc"
        mount --rbind /dev "$root/dev"
        mount --bind "$2" "$root/root/.cache/ccache"
        exec chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin CI="${CI-}" \
            ANEURYSM_WERROR="${ANEURYSM_WERROR-}" sh -c "cd /aneurysm && $3"
    ' sh "$root" "$folder/ccache" "$1"
}
start=$(date +%s)
result=0
inside "$command" >"$folder/$suite.log" 2>&1 || result=$?
tail -n 30 "$folder/$suite.log"

{
    echo "# $(inside '. /etc/os-release; echo $PRETTY_NAME') ($suite), commit $(git -C "$root/aneurysm" rev-parse HEAD)"
    echo
    echo "Made by \`tests/other_system.sh $suite\` on $(date -u +%Y-%m-%d); \`$command\` ended with exit code $result after" \
        "$(($(date +%s) - start)) s."
    echo
    echo "Packages, of cmake/dependencies and cmake/dependencies-test:"
    echo
    echo '```'
    inside 'grep -hv "^#" cmake/dependencies cmake/dependencies-test | cut -d: -f1 |
        xargs dpkg-query -W -f "\${Package} \${Version}\n" 2>/dev/null; c++ --version | head -n 1; ldd --version | head -n 1' ||
        true
    echo '```'
    echo
    echo "Tests, and the recorded runs of \`data/hashes\`:"
    echo
    echo '```'
    grep -E '^== |tests passed|tests failed|\*\*\*|warning:|^All tests|missing, |Not Run' "$folder/$suite.log" | sort | uniq -c |
        sort -rn | cut -c9- || true
    cat "$root/aneurysm/build/release/tests/baseline_report/baseline.txt" || true
    echo '```'
} >"$record"
echo "Record: $record"
exit "$result"
