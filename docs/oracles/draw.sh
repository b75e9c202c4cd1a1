#!/usr/bin/env bash
# Draws the pictures of these pages with the commands that stand in them. usage: docs/oracles/draw.sh [NAME...]
set -euo pipefail
cd "$(dirname "$0")/../.."
PATH="$PWD/build/release:$PATH"
[ $# -gt 0 ] || mapfile -t names < <(sed -n 's/^    ordo oracle \([a-z0-9_]*\) .*--plot .*/\1/p' docs/oracles/*.md)
[ $# -eq 0 ] || names=("$@")
for name in "${names[@]}"; do
    command=$(grep -m1 -E "^    ordo oracle $name .*--plot docs/oracles/$name\.svg$" "docs/oracles/$name.md") ||
        { echo "docs/oracles/$name.md: no command draws $name.svg" >&2; exit 1; }
    read -ra words <<<"$command"
    "${words[@]}" >/dev/null
    rm "docs/oracles/$name.gp"
done
