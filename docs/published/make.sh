#!/usr/bin/env bash
# Runs every study of a source and writes its tables to docs/published/<source>.md. usage: docs/published/make.sh [SOURCE...]
set -euo pipefail
cd "$(dirname "$0")/../.."
PATH="$PWD/build/release:$PATH"
sources=("$@")
[ $# -gt 0 ] || sources=(wobbes_tielen_2015 nguyen_2023 bspline_baselines steffen_2008b records)
reports=$(mktemp -d)
trap 'rm -rf "$reports"' EXIT
for source in "${sources[@]}"; do
    page="docs/published/$source.md"
    printf '# studies/%s\n\nMade by `docs/published/make.sh %s`: each study, its errors, the printed values beside them and the verdicts.\n' \
        "$source" "$source" >"$reports/page"
    for study in "studies/$source"/*.json; do
        ordo run "$study" -o "$reports/report.json" >/dev/null 2>&1 || [ $? -eq 1 ]
        printf '\n' >>"$reports/page"
        ordo table "$reports/report.json" --format markdown >>"$reports/page"
    done
    mv "$reports/page" "$page"
done
