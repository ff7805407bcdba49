#!/usr/bin/env bash
# Runs a scheme's emitted Verilog inside the simulated pipeline, in the place of the models of the environment and the illumination unit, and
# compares everything with a run of the models: handshake in every cycle, every result word, picture, cycles and statistics.
#
#   scripts/cosimulate.sh SCHEME SCENE [--size N] [--self-test] [--set KEY=VALUE]... [--config FILE]...
#
# --size draws N x N pixels instead of what the scene file says. --self-test breaks the Verilog in three ways as well and expects to notice.
# WORK=DIR keeps what is built and written in DIR, BUILD=DIR uses that build folder, NO_INSTALL=1 takes it as it is and installs nothing.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
  echo "usage: scripts/cosimulate.sh SCHEME SCENE [--size N] [--self-test] [--set KEY=VALUE]... [--config FILE]..." >&2
  exit 2
}
names=() arguments=() size='' self_test=''
while [ $# -gt 0 ]; do
  case $1 in
    --self-test) self_test=1 ;;
    --size) [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || usage; size=$2; shift ;;
    --set) [ $# -gt 1 ] || usage; arguments+=(--set "$2"); shift ;;
    --config) [ $# -gt 1 ] || usage; arguments+=(--config "$(realpath -- "$2")"); shift ;;
    -*) usage ;;
    *) names+=("$1") ;;
  esac
  shift
done
[ ${#names[@]} -eq 2 ] || usage
scheme=${names[0]} scene=${names[1]}
[ ! -e "$scene" ] || scene=$(realpath -- "$scene")

if [ -n "${WORK:-}" ]; then
  mkdir -p "$WORK"
  work=$(realpath -- "$WORK")
  [ -z "$(ls -A "$work")" ] || { echo "$work is not empty" >&2; exit 2; }
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
cd "$root"
build=${BUILD:-build}
if [ -z "${NO_INSTALL:-}" ]; then
  . scripts/packages.sh
  install_packages "${build_packages[@]}" make verilator
  build_in "$build" bumpsim
  build_in "$build" cosimulate
fi
build=$(realpath -- "$build")
cosimulate=$build/testbench/cosimulation/cosimulate

# The same scene, textures and all, with another frame.
if [ -n "$size" ]; then
  [ -e "$scene" ] || scene=$root/scenes/$scene.toml
  [ -e "$scene" ] && [[ $scene = *.toml ]] || { echo "--size needs a scene file or the name of a shipped scene" >&2; exit 2; }
  mkdir "$work/scene"
  ln -s "$(dirname "$scene")"/* "$work/scene/"
  rm "$work/scene/$(basename "$scene")"
  sed -E "/^\[frame\]/,/^\[/s/^(width|height)( *= *)[0-9]+/\1\2$size/" "$scene" >"$work/scene/$(basename "$scene")"
  scene=$work/scene/$(basename "$scene")
fi

# quietly LOG COMMAND...: shows the output only if the command fails.
quietly() {
  local log=$1
  shift
  "$@" >"$log" 2>&1 || { tail -n 40 "$log" >&2; return 1; }
}

verilated_include() { echo "$(verilator --getenv VERILATOR_ROOT)/include"; }

# What all translated units need, compiled once for a build folder and a Verilator.
translate_runtime() {
  local include source
  include=$(verilated_include)
  runtime=$build/$(verilator --version | cut -d ' ' -f 1,2 | tr ' ' -)
  mkdir -p "$runtime"
  for source in verilated verilated_threads; do
    [ ! -e "$runtime/$source.o" ] || continue
    # shellcheck disable=SC2046  # several options
    quietly "$work/$source.log" g++ -std=c++17 -O2 -fPIC -w -DVM_SC=1 -I"$include" -I"$include/vltstd" $(pkg-config --cflags systemc) \
      -c "$include/$source.cpp" -o "$work/$source.o" || return 1
    mv "$work/$source.o" "$runtime/"
  done
}

# translate UNIT TOP CAPACITY TAIL FOLDER: Verilator's SystemC module of a unit, as FOLDER/UNIT.so.
translate() {
  local unit=$1 top=$2 capacity=$3 tail=$4 folder=$5 objects="$work/objects/$5/$1" include
  include=$(verilated_include)
  mkdir -p "$objects" "$work/$folder"
  quietly "$objects/verilator.log" verilator --sc -O3 -Wall $lint -Wno-DECLFILENAME --top-module "$top" --prefix Vunit -Mdir "$objects" \
    -GCAPACITY="$capacity" -GTAIL="$tail" -y rtl -CFLAGS "-O2 -fPIC -std=c++17" --build "rtl/$top.v" || return 1
  # shellcheck disable=SC2046  # several options
  quietly "$objects/link.log" g++ -std=c++17 -O2 -fPIC -shared -Wl,-Bsymbolic -I"$objects" -I"$root" -isystem "$include" \
    -isystem "$include/vltstd" -DUNIT_PORTS="\"$work/rtl/cosimulation/${unit}_ports.h\"" "$root/testbench/cosimulation/verilated/unit.cpp" \
    "$objects/Vunit__ALL.a" "$runtime"/*.o -Wl,--no-undefined $(pkg-config --cflags --libs systemc) -pthread -o "$work/$folder/$unit.so"
}

passed=0 failed=0
check() {  # check STATUS TEXT
  if [ "$1" -eq 0 ]; then
    echo "ok: $2"
    passed=$((passed + 1))
  else
    echo "FAILED: $2"
    failed=$((failed + 1))
  fi
}
same_rows() { diff <(grep "^$1," "$work/model/stats.csv") <(grep "^$1," "$work/$2/stats.csv"); }
value() { sed -n "s/^run,$1,\(.*\),.*/\1/p" "$work/$2/stats.csv"; }

# compare UNITS: runs the engine with the units in a folder, and holds the result against that of the models.
compare() {
  local status=0 line file out=run-$1
  "$cosimulate" run "$scene" "$scheme" "${arguments[@]}" --units "$work/$1" --out "$work/$out" >"$work/$out.log" 2>&1 || status=$?
  while read -r line; do
    case $line in
      "ok: "*) check 0 "${line#ok: }" ;;
      "FAILED: "*) check 1 "${line#FAILED: }" ;;
    esac
  done <"$work/$out.log"
  if [ ! -e "$work/$out/result.json" ]; then
    cat "$work/$out.log" >&2
    check 1 "the run with Verilog ends (it broke off with status $status)"
    return
  fi
  for file in frame.exr frame.png error.png; do
    [ -e "$work/model/$file" ] || continue
    status=0
    cmp -s "$work/model/$file" "$work/$out/$file" || status=1
    check $status "picture: $file, $(stat -c %s "$work/model/$file") bytes"
  done
  status=0
  [ "$(value cycles model)" = "$(value cycles "$out")" ] || status=1
  check $status "cycles: $(value cycles model) with models, $(value cycles "$out") with Verilog"
  for module in $stages; do
    status=0
    same_rows "$module" "$out" >"$work/difference" || status=1
    check $status "statistics of $module: $(grep -c "^$module," "$work/model/stats.csv") values$(sed -n 's/^> /; Verilog: /p' "$work/difference" | head -n 1)"
  done
  status=0
  for folder in model "$out"; do sed '/^  "host": {/,$d' "$work/$folder/result.json" >"$work/$folder.json"; done
  cmp -s "$work/model.json" "$work/$out.json" || status=1
  check $status "result.json, all but the host's part: $(stat -c %s "$work/model.json") bytes"
}

"$build/bumpsim" rtl "$scheme" --scene "$scene" "${arguments[@]}" --vectors 2 --out "$work/rtl" >"$work/rtl.log"
cd "$work/rtl"  # ROM images are read from here
"$cosimulate" plan "$scene" "$scheme" "${arguments[@]}" --rtl "$work/rtl" >"$work/plan"
translate_runtime
lint=
while read -r unit top capacity tail; do
  echo "translating $top: CAPACITY $capacity, TAIL $tail" >&2
  translate "$unit" "$top" "$capacity" "$tail" units </dev/null
done <"$work/plan"
"$build/bumpsim" run "$scene" --scheme "$scheme" --engine stepped "${arguments[@]}" --out "$work/model" >"$work/model.log"
# Stages, FIFOs and memory ports: the modules in front of the geometry's counters.
stages=$(awk -F, '$2 == "busy" || $2 == "max_occupancy" { print $1 }' "$work/model/stats.csv" | sort -u)
echo "$scheme on $(basename "$scene" .toml), $(value fragments model) fragments ${arguments[*]}"
compare units

if [ -n "$self_test" ]; then
  right=$passed wrong=$failed
  noticed=0 missed=0
  lint=-Wno-fatal
  # notice FOLDER TEXT: the checks of a broken folder must fail.
  notice() {
    passed=0 failed=0
    compare "$1" >"$work/$1.checks" 2>&1
    if [ $failed -gt 0 ]; then
      echo "ok: noticed by $failed of $((failed + passed)) checks: $2"
      sed -n 's/^FAILED: /    /p' "$work/$1.checks" | head -n 2
      noticed=$((noticed + 1))
    else
      echo "FAILED: not noticed: $2"
      missed=$((missed + 1))
    fi
  }
  # broken FOLDER: the right units, to replace one of them.
  broken() { mkdir "$work/$1" && cp "$work"/units/*.so "$work/$1/"; }
  read -r unit top capacity tail <"$work/plan"
  broken late
  translate "$unit" "$top" "$capacity" $((tail + 1)) late
  notice late "the $unit unit is a cycle late"
  broken narrow
  translate "$unit" "$top" 1 "$tail" narrow
  notice narrow "the $unit unit holds one token at a time"
  read -r unit top capacity tail < <(tail -n 1 "$work/plan")
  broken word
  count='  reg [31:0] count;\n  always @(posedge clk) count <= reset ? 0 : count + (finished ? 1 : 0);\n'
  sed -i -E "s/^( *assign released = )(result.*);/\1count == 99 ? ~\2 : \2;/; s/^endmodule/${count}endmodule/" "rtl/$top.v"
  translate "$unit" "$top" "$capacity" "$tail" word
  notice word "one result of the $unit unit is wrong"
  passed=$((right + noticed)) failed=$((wrong + missed))
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
