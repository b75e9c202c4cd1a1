#!/usr/bin/env bash
# Accepts studies as baselines: tools/accept.sh REASON [STUDY...]; without a study, all that have a baseline.
# Each runs in two builds, the release and a twin that fuses multiplications and additions (preset `fma`; needs an
# x86-64-v3 CPU). The scatter between both is what the tolerances are made of.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"

[ $# -ge 1 ] || { echo "usage: tools/accept.sh REASON [STUDY...]" >&2; exit 2; }
reason=$1
shift
studies=("$@")
cd "$root"
if [ ${#studies[@]} -eq 0 ]; then
    mapfile -t studies < <(cd reports/baseline && find . -name '*.json' | sort | sed 's|^\.|studies|')
fi

install_missing "${build_packages[@]}"
for preset in release fma; do
    quietly "configure_$preset" cmake -S "$root" --preset "$preset"
    build ordo "$preset"
done

refused=()
for study in "${studies[@]}"; do
    for preset in release fma; do
        report=build/accept/$preset/$study
        rm -f "$report"
        # A failing gate still leaves a report, which is refused below with the reason.
        "build/$preset/ordo" run "$study" -o "$report" --jobs 1 --no-cache >/dev/null 2>&1 || [ -f "$report" ] || continue
    done
    build/release/ordo accept "build/accept/release/$study" "build/accept/fma/$study" --because "$reason" ||
        refused+=("$study")
done
[ ${#refused[@]} -eq 0 ] || { printf 'not accepted: %s\n' "${refused[@]}" >&2; exit 1; }
