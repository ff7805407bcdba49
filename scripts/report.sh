#!/usr/bin/env bash
# Writes everything in reports/ but checks.md: Table 1, Table 2, a comparison of all schemes on every shipped scene, the main job's table, and
# pictures. About a minute.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. scripts/packages.sh
install_packages "${build_packages[@]}" python3 imagemagick
build_in build bumpsim
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scenes="wood_plane brick_cube world_sphere brick_torus bunny"
mkdir -p reports/pictures
smaller=(-strip -define png:exclude-chunks=date,time)

build/bumpsim table1 --format md --out reports/table1.md --force
build/bumpsim table2 --angles --format md --out reports/table2.md --force
for scene in $scenes; do
  build/bumpsim compare "$scene" --schemes all --out "$work/$scene" >/dev/null
  cp "$work/$scene/compare.md" "reports/compare-$scene.md"
  convert "$work/$scene/compare.png" -resize 1200x -strip -quality 88 "reports/pictures/compare-$scene.jpg"
done
python3 scripts/main_job_table.py "$work" >reports/main_job.md

frame() { build/bumpsim run "$1" --scheme "$2" --out "$work/$1-$2" >/dev/null; }
for scene in $scenes; do
  frame "$scene" lee2007
  frame "$scene" peercy1997
done
convert "$work/world_sphere-lee2007/frame.png" "$work/world_sphere-peercy1997/frame.png" "$work/world_sphere-lee2007/error.png" \
  +append -resize 1200x "${smaller[@]}" reports/pictures/world_sphere.png
for scheme in lee2007 peercy1997; do
  convert "$work"/{wood_plane,brick_cube,world_sphere,brick_torus,bunny}-"$scheme"/frame.png +append -resize 1200x "${smaller[@]}" \
    "reports/pictures/scenes-$scheme.png"
done
echo "reports/ is up to date"
