#!/usr/bin/env bash
# Who is fastest at which error: tools/leaderboard.sh [-o DIR] [--set path=value]... [STUDY...]
# Times the studies of studies/leaderboard (or those named), one run at a time, and makes docs/leaderboard.md with its
# pictures in docs/leaderboard, and the table in the README. For trying: another folder instead of docs, and fewer or shorter runs, as in
#   tools/leaderboard.sh -o build/try --set timeout_s=0.2 studies/leaderboard/sod.json
# A quiet machine matters; about 15 minutes. Reports stay in build/leaderboard, or in the folder of -o. The exit code is
# that of the first run that did not hold its expectations.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"

docs=docs
reports=build/leaderboard
settings=()
studies=()
while [ $# -gt 0 ]; do
    case $1 in
        -o | --set)
            [ $# -ge 2 ] || { echo "leaderboard.sh: $1 needs a value" >&2; exit 2; }
            if [ "$1" = -o ]; then docs=$2 reports=$2; else settings+=(--set "$2"); fi
            shift
            ;;
        -*) echo "usage: tools/leaderboard.sh [-o DIR] [--set path=value]... [STUDY...]" >&2; exit 2 ;;
        *) studies+=("$1") ;;
    esac
    shift
done
cd "$root"
[ ${#studies[@]} -gt 0 ] ||
    for name in bar_vibration bar_mms_small bar_mms_large oedometer bar_traction sod toro_4 elastic_collision sedov; do
        studies+=("studies/leaderboard/$name.json")
    done
errors=1e-2,1e-4,1e-6,1e-8

install_missing "${build_packages[@]}"
quietly configure cmake -S "$root" --preset release
build ordo
ordo=build/release/ordo

status=0
made=()
mkdir -p "$reports" "$docs/leaderboard"
for study in "${studies[@]}"; do
    report=$reports/$(basename "$study")
    rm -f "$report"
    echo "$study" >&2
    "$ordo" run "$study" --time -o "$report" "${settings[@]}" >"${report%.json}.txt" || {
        code=$?
        [ $code -eq 1 ] || [ $code -eq 3 ] || exit $code
        grep -E '^(fail|inconclusive)' "${report%.json}.txt" >&2 || true
        [ $status -ne 0 ] || status=$code
    }
    made+=("$report")
done

pictures=$reports/pictures
mkdir -p "$pictures"
for report in "${made[@]}"; do
    "$ordo" plot "$report" -o "$pictures" --against time,work --reach $errors >/dev/null
done
[ ${#made[@]} -eq 1 ] || "$ordo" plot "${made[@]}" -o "$pictures" --against time >/dev/null
rm -f "$docs"/leaderboard/*.svg
cp "$pictures"/*-time.svg "$docs/leaderboard/"

{
    cat tools/leaderboard_head.md
    [ ${#made[@]} -eq 1 ] || printf '![Error against run time, a panel a study](leaderboard/board-time.svg)\n\n'
    "$ordo" table "${made[@]}" --rank $errors --format markdown
    printf '\n## Pictures\n'
    for report in "${made[@]}"; do
        name=$(basename "$report" .json)
        for picture in "$docs"/leaderboard/leaderboard_"$name"-*-time.svg; do
            printf '\n![%s: error against run time](leaderboard/%s)\n' "$name" "$(basename "$picture")"
        done
    done
} >"$docs/leaderboard.md.new"
mv "$docs/leaderboard.md.new" "$docs/leaderboard.md"
echo "$docs/leaderboard.md" >&2

# The README shows the first table: who is fastest.
if [ "$docs" = docs ] && [ ${#made[@]} -gt 1 ]; then
    fastest=$(awk '/^\| study/ { inside = 1 } inside && /^$/ { exit } inside' docs/leaderboard.md)
    export fastest
    awk '/^<!-- end of the leaderboard -->/ { inside = 0 }
         !inside { print }
         /^<!-- leaderboard, by tools\/leaderboard.sh -->/ { print "\n" ENVIRON["fastest"] "\n"; inside = 1 }' \
        README.md >README.md.new
    mv README.md.new README.md
fi
exit "$status"
