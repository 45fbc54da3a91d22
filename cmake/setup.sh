# What ./run and ./test share: packages, configuring, building. Sourced; all it says goes to stderr,
# so that the program's standard output stays clean.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { echo "bozzetto: $*" >&2; }
die() { say "$*"; exit 1; }

isInstalled() {
  [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

# The packages of the given purposes that are not installed yet.
missingPackages() {
  local purpose choice
  for purpose in "$@"; do
    for choice in $(sed -n "s/^$purpose: //p" "$root/cmake/packages.txt"); do
      isInstalled "${choice%%|*}" || isInstalled "${choice##*|}" || echo "${choice%%|*}"
    done
  done | sort -u
}

# Installs what is missing for the given purposes; says nothing when nothing is.
needPackages() {
  local missing apt sudo=()
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian machine: needs what cmake/packages.txt names ($*)"
    return
  fi
  mapfile -t missing < <(missingPackages "$@")
  ((${#missing[@]})) || return 0
  if [[ $(id -u) != 0 ]]; then
    command -v sudo >/dev/null || die "please install as root: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  say "installing ${missing[*]}"
  mkdir -p "$root/build"
  # Another package manager may be at work: wait for its lock.
  apt=("${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y
       -o DPkg::Lock::Timeout=600 -o Acquire::Retries=3)
  {
    "${apt[@]}" update || say "apt-get update failed; going on with the lists at hand"
    "${apt[@]}" install --no-install-recommends "${missing[@]}"
  } >"$root/build/packages.log" 2>&1 || {
    tail -n 20 "$root/build/packages.log" >&2
    die "could not install ${missing[*]}"
  }
}

# configure PRESET [cmake arguments]: silent unless it fails.
configure() {
  local preset=$1 folder="$root/build/$1"
  shift
  mkdir -p "$folder"
  if ! (cd "$root" && cmake --preset "$preset" "$@") >"$folder/configure.log" 2>&1; then
    cat "$folder/configure.log" >&2
    die "configuring $preset failed"
  fi
}

# As many compilers at once as there are processors, and 1.5 GiB of memory for each.
buildJobs() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '/MemAvailable/ {print int($2 / 1572864)}' /proc/meminfo)
  ((memory < processors)) && processors=$memory
  echo $((processors > 0 ? processors : 1))
}

# build PRESET [target...]: one line of progress on a terminal, errors in full, else silence.
build() {
  local preset=$1 terminal=0
  shift
  [[ -t 2 ]] && terminal=1
  ninja -C "$root/build/$preset" -j "$(buildJobs)" "$@" 2>&1 |
    awk -v terminal=$terminal -v preset="$preset" '
      /Re-checking globbed|Re-running CMake|Entering directory|no work to do/ {next}
      /^-- / {next}
      /^\[[0-9]+\/[0-9]+\]/ {
        if (!said++) print "bozzetto: building (" preset ")"
        if (terminal) {printf "\r\033[K%s", substr($0, 1, 78); open = 1; fflush()}
        next
      }
      {if (open) print ""; open = 0; print; fflush()}
      END {if (open) printf "\r\033[K"}' >&2
}
