#!/usr/bin/env bash
# Draws the pictures of these pages with the commands that stand in them. usage: docs/oracles/draw.sh [NAME...]
set -euo pipefail
cd "$(dirname "$0")/../.."
PATH="$PWD/build/release:$PATH"
[ $# -gt 0 ] || set -- $(cd docs/oracles && ls ./*.md | sed -n 's/^\.\/\([a-z0-9_]*\)\.md$/\1/p')
for name in "$@"; do
    command=$(grep -m1 -E "^    ordo oracle $name .*--plot docs/oracles/$name\.svg$" "docs/oracles/$name.md") ||
        { echo "docs/oracles/$name.md: no command draws $name.svg" >&2; exit 1; }
    read -ra words <<<"$command"
    "${words[@]}" >/dev/null
    rm "docs/oracles/$name.gp"
done
