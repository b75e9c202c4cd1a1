#!/usr/bin/env bash
# Installs what is missing, builds everything, and runs all tests; arguments go to ctest: ./test.sh -L unit
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tools/setup.sh
source "$root/tools/setup.sh"

install_missing "${test_packages[@]}"
quietly configure cmake -S "$root" --preset release -DORDO_TESTS=ON
build all
cd "$root"
exec ctest --preset release --parallel 2 "$@"
