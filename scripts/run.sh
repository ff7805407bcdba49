#!/usr/bin/env bash
# Installs what is missing, builds, and runs bumpsim. Arguments are passed on; without any, renders the bump-mapped Earth.
#   scripts/run.sh
#   scripts/run.sh run brick_torus --scheme peercy1997
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
invoked_from=$PWD
cd "$here"
. scripts/packages.sh
install_packages "${build_packages[@]}"
build_in build bumpsim
cd "$invoked_from"
if [ $# -eq 0 ]; then set -- run world_sphere; fi
exec "$here/build/bumpsim" "$@"
