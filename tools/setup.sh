# shellcheck shell=bash disable=SC2034,SC2154
# Sourced by run.sh and test.sh: what both need before they can run anything. `root` is the project's folder.
# Every failure here is one of the environment: exit code 4, as the command `ordo` has it.

build_packages=(g++ cmake ninja-build libeigen3-dev libboost-dev libboost-math-dev libboost-program-options-dev
    libgsl-dev nlohmann-json3-dev libfmt-dev libxxhash-dev gnuplot-nox fonts-dejavu-core)
test_packages=("${build_packages[@]}" catch2 libvalijson-dev python3-jsonschema)

fail() {
    echo "$(basename "$0"): $*" >&2
    exit 4
}

# quietly NAME COMMAND...: output goes to build/NAME.log, which is shown only when the command fails.
quietly() {
    local log="$root/build/$1.log"
    shift
    mkdir -p "$root/build"
    "$@" >"$log" 2>&1 || {
        cat "$log" >&2
        fail "failed: $* (output above, and in $log)"
    }
}

# Those of the given Debian packages that are not installed, one a line.
missing_packages() {
    local installed package
    installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null) || true
    for package in "$@"; do
        grep -qxF "$package installed" <<<"$installed" || echo "$package"
    done
}

# Installs those of the given Debian packages that are missing. On another system it only says what is needed.
install_missing() {
    local missing as_root=() options=(--yes --no-install-recommends -o DPkg::Lock::Timeout=120)
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "$(basename "$0"): not a Debian system, nothing is installed; needed are (Debian's names): $*" >&2
        return
    fi
    mapfile -t missing < <(missing_packages "$@")
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null ||
            fail "packages are missing; as root: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
        as_root=(sudo)
    fi
    echo "Installing Debian packages: ${missing[*]}" >&2
    # Another source's stale list must not stop us: what matters fails in the next command.
    "${as_root[@]}" apt-get -q update >/dev/null || echo "apt-get update failed; going on with the lists at hand" >&2
    quietly packages "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q install "${options[@]}" "${missing[@]}"
}

# build TARGET [PRESET]: builds one target in build/PRESET, by default release: ninja's progress on stderr, without the lines that even an idle build prints.
build() {
    local idle='^\[[0-9]+/[0-9]+\] (Re-checking globbed directories\.\.\.|.*build_facts(\.cmake)?)$|^ninja: no work to do\.$'
    cmake --build "$root/build/${2:-release}" --target "$1" | { grep --line-buffered -vE "$idle" || true; } >&2 ||
        fail "the build failed"
}
