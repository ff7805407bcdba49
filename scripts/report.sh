#!/usr/bin/env bash
# Writes reports/main_job.md and reports/pictures: every scheme on every shipped scene, cost and quality. A few seconds a scheme.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}" python3 imagemagick
build_in build bumpsim
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
schemes=$(build/bumpsim list schemes | awk 'NR > 1 { print $1 }')
for scene in wood_plane brick_cube world_sphere brick_torus bunny; do
  for scheme in $schemes; do
    build/bumpsim run "$scene" --scheme "$scheme" --out "$work/$scene-$scheme" >/dev/null 2>"$work/errors" || { cat "$work/errors" >&2; exit 1; }
  done
done
python3 scripts/main_job_table.py "$work" >reports/main_job.md
mkdir -p reports/pictures
convert "$work/world_sphere-lee2007/frame.png" "$work/world_sphere-peercy1997/frame.png" "$work/world_sphere-lee2007/error.png" \
  +append -resize 1200x -strip -define png:exclude-chunks=date,time reports/pictures/world_sphere.png
for scheme in lee2007 peercy1997; do
  convert "$work"/{wood_plane,brick_cube,world_sphere,brick_torus,bunny}-"$scheme"/frame.png +append -resize 1200x -strip \
    -define png:exclude-chunks=date,time "reports/pictures/scenes-$scheme.png"
done
echo "reports/main_job.md and reports/pictures are up to date"
