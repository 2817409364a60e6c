# shellcheck shell=bash
# Sourced by ./run and ./check: packages, configuration and build, in one place.
# Call with the current directory at the top of the project.

ew_say() { printf '%s\n' "$*" >&2; }

# ew_missing_packages LIST...: the package names in resources/packages/LIST.txt that are not installed.
ew_missing_packages() {
  local list name
  for list in "$@"; do
    while read -r name; do
      case $name in '' | \#*) continue ;; esac
      [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || printf '%s\n' "$name"
    done <"resources/packages/$list.txt"
  done
}

# ew_install LIST...: installs what is missing, after saying what and how much.
ew_install() {
  local packages missing
  mapfile -t packages < <(ew_missing_packages "$@")
  [ ${#packages[@]} -gt 0 ] || return 0
  missing=${packages[*]}
  if ! command -v apt-get >/dev/null; then
    ew_say "These Debian packages are missing and there is no apt-get here to install them: $missing"
    return 1
  fi
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      ew_say "These packages are missing: $missing"
      ew_say "Install them as root, then start again: apt-get install --no-install-recommends $missing"
      return 1
    fi
    as_root=(sudo)
  fi
  ew_say "Missing Debian packages: $missing"
  local log
  log=$(mktemp)
  if ! "${as_root[@]}" apt-get update >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    ew_say "The package lists could not be updated; check the network, then start again."
    return 1
  fi
  "${as_root[@]}" env LC_ALL=C apt-get install --no-install-recommends --assume-no "${packages[@]}" 2>/dev/null |
    grep -E '^Need to get|^After this operation|newly installed' >&2 || true
  ew_say "Installing them now."
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${packages[@]}" >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    ew_say "The installation failed; the last lines above say why. The whole log is in $log."
    return 1
  fi
  rm -f "$log"
}

# ew_build PRESET [TARGET...]: configures when needed, then builds.
ew_build() {
  local preset=$1
  shift
  local targets=()
  [ $# -eq 0 ] || targets=(--target "$@")
  export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros
  # A build folder knows where its sources lay: one that was copied or moved would go on building those of the other place.
  if [ -f "build/$preset/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "build/$preset/CMakeCache.txt"; then
    ew_say "build/$preset was made for another folder; it is made anew."
    rm -rf "build/$preset"
  fi
  if [ ! -f "build/$preset/build.ninja" ]; then
    local log
    log=$(mktemp)
    if ! cmake --preset "$preset" >"$log" 2>&1; then
      tail -n 30 "$log" >&2
      ew_say "The build could not be configured; the lines above say why. The whole log is in $log."
      return 1
    fi
    rm -f "$log"
  fi
  cmake --build "build/$preset" "${targets[@]}" >&2
}

# ew_start_screen: starts a virtual screen, waits until it answers, and sets DISPLAY and ew_screen (its process id). A busy machine may
# need long for that, and a display number may be taken in the meantime, so it waits a minute, tries three times and shows what was said.
ew_start_screen() {
  local log number attempt display
  log=$(mktemp)
  number=$(mktemp)
  for attempt in 1 2 3; do
    : >"$number"
    display=()
    [ "$attempt" -eq 1 ] || display=(":$((100 + RANDOM % 800))")
    Xvfb "${display[@]}" -displayfd 3 -screen 0 1920x1080x24 -noreset 3>"$number" 2>"$log" &
    ew_screen=$!
    for _ in $(seq 600); do
      if [ -s "$number" ] || ! kill -0 "$ew_screen" 2>/dev/null; then break; fi
      sleep 0.1
    done
    if [ -s "$number" ]; then
      DISPLAY=:$(tr -d '[:space:]' <"$number")
      export DISPLAY
      rm -f "$log" "$number"
      return 0
    fi
    kill "$ew_screen" 2>/dev/null || true
    ew_say "The virtual screen (Xvfb) did not start (attempt $attempt of 3). It said:"
    cat "$log" >&2
  done
  rm -f "$log" "$number"
  return 1
}

# ew_minutes SECONDS: as one reads it.
ew_minutes() { printf '%d min %02d s' $(($1 / 60)) $(($1 % 60)); }

# ew_ctest FOLDER [ARGS...]: runs the tests of a build folder and remembers how they ended for ew_finish.
ew_results=()
ew_failed=0
ew_ctest() {
  local folder=$1 results
  shift
  results=$(mktemp)
  ew_results+=("$results")
  ctest --test-dir "$folder" --output-on-failure -j "$(nproc)" --output-junit "$results" "$@" || ew_failed=1
}

# ew_tally FILE...: one line from the results of ctest: how many tests passed, failed and were skipped, and why they were.
ew_tally() {
  awk '
    /<testcase / { ++tests; status = $0; sub(/.* status="/, "", status); sub(/".*/, "", status); reading = status == "notrun"; told = 0
      if (status == "run") ++passed; else if (status == "fail") ++failed; else if (status == "notrun") ++skipped; else ++disabled }
    reading && !told && because { sub(/<.*/, ""); why = $0; if (sub(/^for want of recordings.*/, "for want of recordings (../shared/data)", why)); ++reasons[why]; told = 1; because = 0 }
    reading && /: Skipped$/ { because = 1 }
    END {
      printf "%d tests: %d passed, %d failed, %d skipped", tests, passed, failed, skipped
      separator = ": "
      for (why in reasons) { printf "%s%d %s", separator, reasons[why], why; separator = "; " }
      if (disabled) printf "; %d disabled", disabled
      printf "\n"
      exit tests == 0
    }' "$@"
}

# ew_sanitizers_run: whether a program with the address and undefined-behaviour sanitizers ends well here (leaks are looked for by way of
# ptrace, which some containers do not allow).
ew_sanitizers_run() {
  local folder status=0
  folder=$(mktemp -d)
  printf 'int main() { return 0; }\n' >"$folder/one.cpp"
  c++ -fsanitize=address,undefined -o "$folder/one" "$folder/one.cpp" 2>/dev/null && "$folder/one" 2>/dev/null || status=1
  rm -rf "$folder"
  return "$status"
}

# ew_finish: the last two lines of ./check, and its exit status.
ew_finish() {
  local status=$ew_failed
  ew_tally "${ew_results[@]}" || status=1
  rm -f "${ew_results[@]}"
  if [ "$status" -eq 0 ]; then
    printf 'All is well after %s.\n' "$(ew_minutes "$SECONDS")"
  else
    printf 'Not all is well, after %s; the failures are above.\n' "$(ew_minutes "$SECONDS")"
  fi
  exit "$status"
}
