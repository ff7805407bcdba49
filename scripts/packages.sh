# Sourced by the other scripts: installs the Debian packages that the build needs and this machine lacks.

build_packages=(g++ cmake ninja-build pkg-config libsystemc-dev libglm-dev libopenimageio-dev libcli11-dev libtomlplusplus-dev
  nlohmann-json3-dev libfmt-dev libtinyobjloader-dev libpng-dev libopenexr-dev catch2)

# install_packages NAME...: does nothing, and needs no network, when all are there.
install_packages() {
  local missing=() package
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  command -v apt-get >/dev/null || {
    echo "these packages are missing and there is no apt-get to install them: ${missing[*]}" >&2
    return 1
  }
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "these packages are missing; install them as root: apt-get install ${missing[*]}" >&2
      return 1
    }
    root=(sudo)
  fi
  echo "installing: ${missing[*]}" >&2
  "${root[@]}" apt-get update -qq >&2
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build_in FOLDER TARGET [CMAKE-OPTION...]: configures once and builds; the compiler's output is shown only if something fails.
build_in() {
  local folder=$1 target=$2 log
  shift 2
  mkdir -p "$folder"
  log=$folder/build.log
  echo "building in $folder (log: $log)" >&2
  if ! { cmake -S . -B "$folder" -G Ninja "$@" && cmake --build "$folder" --target "$target"; } >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    echo "the build failed; the whole log is in $log" >&2
    return 1
  fi
}
