# Shared by app/run and tests/run (sourced, POSIX shell): installs what is missing, configures, builds.
# Sets: root, build.

set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build

# Packages of Debian 12; Ubuntu 24.04 has the same names.
packages_core="g++ make cmake ninja-build pkg-config libeigen3-dev libsundials-dev libfmt-dev nlohmann-json3-dev
  libcli11-dev libssl-dev libpng-dev libepoxy-dev libgl1-mesa-dev libegl1-mesa-dev libgl1-mesa-dri libegl1 libglx-mesa0"
packages_window="qt6-base-dev qt6-tools-dev qt6-l10n-tools qt6-translations-l10n libqt6opengl6-dev qt6-svg-dev libwebp-dev qt6-qpa-plugins libxkbcommon-dev libxcb-cursor0
  fonts-dejavu-core qt6-speech-dev qt6-declarative-dev qt6-speech-speechd-plugin speech-dispatcher
  speech-dispatcher-espeak-ng"
packages_tests="libgtest-dev libgmock-dev libbenchmark-dev xvfb xauth"

say() { printf '%s\n' "$*" >&2; }

die() {
    say "$*"
    exit 1
}

# The packages of the arguments that are not installed.
missing_packages() {
    for package in "$@"; do
        case $(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) in
        *" installed") ;;
        *) printf ' %s' "$package" ;;
        esac
    done
}

install_packages() {
    if ! command -v dpkg-query >/dev/null 2>&1; then
        say "This system has no dpkg. Install the counterparts of these packages, then call this again:"
        say "  $*"
        return 0
    fi
    # Asking for all at once is quick; only when something is missing each is looked at.
    wanted=$(echo "$@" | wc -w)
    there=$(dpkg-query -W -f='${Status}\n' "$@" 2>/dev/null | grep -c ' installed$' || true)
    [ "$there" -lt "$wanted" ] || return 0
    missing=$(missing_packages "$@")
    [ -n "$missing" ] || return 0

    command_line="apt-get update && apt-get install -y --no-install-recommends$missing"
    if [ "$(id -u)" = 0 ]; then
        as_root="env DEBIAN_FRONTEND=noninteractive"
    elif command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
        as_root="sudo env DEBIAN_FRONTEND=noninteractive"
    else
        die "Some packages are missing and this user may not install them. Run as root:
  $command_line"
    fi
    say "Installing:$missing"
    # Lists may be old or absent: refresh once, and say what to do when the network refuses.
    # shellcheck disable=SC2086
    $as_root apt-get update -qq >&2 || die "apt-get update failed. Check the network, then run as root:
  $command_line"
    # shellcheck disable=SC2086
    $as_root apt-get install -y -qq --no-install-recommends $missing >&2 ||
        die "Installing failed. Run as root:
  $command_line"
}

# configure CMAKE-OPTION... : only when there is no build yet or an option differs from the last time.
configure() {
    generator=
    [ -f "$build/CMakeCache.txt" ] || generator="-G Ninja"
    launcher=
    if command -v ccache >/dev/null 2>&1; then
        launcher="-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache"
    fi
    # KNITTSIM_CONFIGURE: further options for special builds, as in .ci/run.
    wanted="$* ${KNITTSIM_CONFIGURE:-}"
    if [ -f "$build/build.ninja" ] && [ "$(cat "$build/.configured-with" 2>/dev/null)" = "$wanted" ]; then
        return 0
    fi
    say "Configuring in build/"
    mkdir -p "$build"
    # shellcheck disable=SC2086
    cmake -S "$root" -B "$build" $generator -DCMAKE_BUILD_TYPE=Release $launcher $wanted \
        >"$build/configure.log" 2>&1 || {
        cat "$build/configure.log" >&2
        die "Configuring failed; see above."
    }
    printf '%s' "$wanted" >"$build/.configured-with"
}

# build_targets TARGET... : says nothing when there is nothing to do.
build_targets() {
    if [ -t 2 ]; then
        cmake --build "$build" --target "$@" >&2
    else
        log=$build/build.log
        say "Building"
        cmake --build "$build" --target "$@" >"$log" 2>&1 || {
            tail -n 60 "$log" >&2
            die "Building failed; the whole output is in build/build.log."
        }
    fi
}
