#!/usr/bin/env bash
# Installs what is missing, builds, and runs the command: ./run.sh ARGUMENTS is `ordo ARGUMENTS`.
# Without arguments: the flagship study, its table and its plots. The exit code is that of `ordo`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"

install_missing "${build_packages[@]}"
quietly configure cmake -S "$root" --preset release
build ordo
ordo="$root/build/release/ordo"
[ $# -eq 0 ] || exec "$ordo" "$@"

reports="$root/build/reports"
report="$reports/vibrating_bar.json"
status=0

# Goes on when a command fails, but keeps the first exit code that is not 0.
keep() {
    "$@" || {
        local code=$?
        [ "$status" -ne 0 ] || status=$code
    }
}

mkdir -p "$reports"
rm -f "$report"
keep "$ordo" run "$root/studies/wobbes_tielen_2015/vibrating_bar.json" -o "$report"
[ -f "$report" ] || exit "$status"
for format in svg pdf png; do
    keep "$ordo" plot "$report" -o "$reports" --format "$format" >/dev/null
done

printf '\nReport and plots:\n%s\n' "$report"
find "$reports" -newer "$report" \( -name '*.svg' -o -name '*.pdf' -o -name '*.png' \) | sort
exit "$status"
