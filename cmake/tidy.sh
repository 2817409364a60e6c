# shellcheck shell=bash
# Sourced by ./check after cmake/setup.sh: clang-tidy with the checks of .clang-tidy.
# Call with the current directory at the top of the project, build/dev built: headers that the build makes are read there.

# ew_tidy_commands FOLDER: writes FOLDER/compile_commands.json with one entry for each source. The build joins several sources into one and
# precompiles headers in GCC's own form, neither of which clang-tidy can use; and which warnings are asked for is .clang-tidy's to say.
ew_tidy_commands() {
  mkdir -p "$1"
  awk '
    function entry(file) {
      printf "%s{\"directory\": \"%s\", \"command\": \"%s -c \\\"%s\\\"\", \"file\": \"%s\"}", separator, directory, command, file, file
      separator = ",\n"
    }
    function value(line) { sub(/^ *"[a-z]*": "/, "", line); sub(/",?$/, "", line); return line }
    BEGIN { print "[" }
    /^ *"directory": / { directory = value($0) }
    /^ *"command": / {
      command = value($0)
      gsub(/ -include [^ ]*cmake_pch\.hxx| -fpch-preprocess| -W[^ ]*/, "", command)
      sub(/ -o .*/, "", command)
      sub(/^[^ ]*ccache /, "", command)
    }
    /^ *"file": / {
      file = value($0)
      if (file !~ /\/Unity\/unity_[^\/]*$/) entry(file)
      else while ((getline line <file) > 0) if (sub(/^#include "/, "", line) && sub(/"$/, "", line)) entry(line)
    }
    END { print "\n]" }' build/dev/compile_commands.json >"$1/compile_commands.json"
}

# ew_changed_files: what changed against what this tree came from, newest first: what is not committed, then the commits since the branch
# left origin/main or, on it, since the last tag; the last twenty commits where there is neither. Fails where no history tells.
ew_changed_files() {
  local base='' since=(-n 20)
  [ "$(git rev-parse --show-toplevel 2>/dev/null)" = "$PWD" ] && git rev-parse --quiet --verify HEAD^ >/dev/null || return 1
  base=$(git merge-base HEAD origin/main 2>/dev/null) || true
  if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then base=$(git describe --tags --abbrev=0 HEAD^ 2>/dev/null) || true; fi
  [ -z "$base" ] || since=("$base..HEAD")
  git -c core.quotePath=off diff --name-only HEAD
  git -c core.quotePath=off ls-files --others --exclude-standard
  git -c core.quotePath=off log --first-parent -m --name-only --format= "${since[@]}"
}

# ew_tidy_sources FOLDER [FILE...]: those of the given files (from the top of the project; all without any) that clang-tidy has a command
# for, each once, in their order; a header stands for the source of its name in the same library.
ew_tidy_sources() {
  local commands=$1/compile_commands.json
  shift
  grep -oE '"file": "[^"]*' "$commands" | cut -c10- | grep -E "^$PWD/(workstation|plugins|tests)/" | cut -c$((${#PWD} + 2))- | sort -u |
    if [ $# -eq 0 ]; then cat; else
      awk '
        function key(path) { match(path, /^[^\/]*\/[^\/]*\//); name = path; gsub(/^.*\/|\.[a-z]*$/, "", name); return substr(path, 1, RLENGTH) name }
        FNR == NR { is[$0] = 1; named[key($0)] = $0; next }
        { file = /\.h$/ ? named[key($0)] : $0 }
        file in is && !seen[file]++ { print file }' - <(printf '%s\n' "$@")
    fi
}

# ew_tidy_groups FOLDER MOST FILE...: puts the files that stand in one library and have the same command into groups, up to MOST in one but
# no more than leave work for every processor, in the order of the first of each, and prints the groups' folders. A group's source includes its
# files, so that the headers are read once; it is called UnifiedSource because the static analyzer looks into the sources that a source
# includes under that name alone. GROUP/files lists them.
ew_tidy_groups() {
  local folder=$1 limit=$2 most
  shift 2
  most=$((($# + $(nproc) - 1) / $(nproc)))
  [ "$most" -le "$limit" ] || most=$limit
  rm -rf "$folder"/group-*
  awk -v top="$PWD/" -v folder="$PWD/$folder" -v most="$most" '
    FNR == NR { wanted[++files] = $0; next }
    /"file": "/ {
      file = $0
      sub(/^.*"file": "/, "", file)
      sub(/".*$/, "", file)
      command[file] = $0
      sub(/^{/, "", command[file])
    }
    END {
      for (i = 1; i <= files; ++i) {
        file = top wanted[i]
        line = command[file]
        at = index(line, " -c ")
        match(wanted[i], /^[^\/]*\/[^\/]*\//)
        key = substr(wanted[i], 1, RLENGTH) substr(line, 1, at - 1)
        if (!(key in group) || size[group[key]] == most) group[key] = ++groups
        n = group[key]
        start[n] = substr(line, 1, at - 1)
        list[n] = list[n] wanted[i] "\n"
        text[n] = text[n] "#include \"" file "\"  // NOLINT(bugprone-suspicious-include)\n"
        ++size[n]
      }
      for (n = 1; n <= groups; ++n) {
        own = folder "/group-" n
        system("mkdir -p \"" own "\"")
        source = own "/UnifiedSource.cpp"
        printf "%s", list[n] >(own "/files")
        printf "%s", text[n] >source
        printf "[{%s -c \\\"%s\\\"\", \"file\": \"%s\"}]\n", start[n], source, source >(own "/compile_commands.json")
        close(own "/files")
        close(source)
        close(own "/compile_commands.json")
        print own
      }
    }' <(printf '%s\n' "$@") "$folder/compile_commands.json"
}

# ew_tidy_ours: of what clang-tidy says, all but leaks inside Qt's headers: it does not know that Qt lets go of a call that waits
# (QMetaObject::invokeMethod, QTimer::singleShot).
ew_tidy_ours() {
  awk '/^[^ ].*: (error|warning): / { isQts = /\/qt[56]\/.*Potential memory leak/ } !isQts'
}

# ew_tidy_run FOLDER END SOURCE: clang-tidy over one source by FOLDER/compile_commands.json, unless less than thirty seconds are left to END
# (in seconds since 1970; 0: it never ends). Its findings are in `said`; fails with 124 where the time was up.
ew_tidy_run() {
  local limit=() status=0
  said=''
  if [ "$2" -gt 0 ]; then
    local left=$(($2 - $(date +%s)))
    [ "$left" -gt 30 ] || return 124
    limit=(timeout "$left")
  fi
  said=$("${limit[@]}" clang-tidy --quiet -p "$1" --warnings-as-errors='*' "$3" 2>"$1/errors.$$") || status=$?
  if [ "$status" -eq 1 ] && [ -n "$said" ]; then
    said=$(ew_tidy_ours <<<"$said")
    [ -n "$said" ] || status=0
  fi
  [ "$status" -eq 0 ] || [ -n "$said" ] || said=$(<"$1/errors.$$")
  rm -f "$1/errors.$$"
  return "$status"
}

# ew_tidy_group FOLDER END GROUP: looks at the files of a group together, or at its halves where they do not compile as one (two of them use
# a name for different things), and marks in FOLDER/seen which it looked at and how that ended.
ew_tidy_group() {
  local files status=0
  mapfile -t files <"$3/files"
  if [ ${#files[@]} -eq 1 ]; then
    ew_tidy_run "$3" "$2" "${files[0]}" || status=$?
  else
    ew_tidy_run "$3" "$2" "$3/UnifiedSource.cpp" || status=$?
    case $said in
      *clang-diagnostic-error*)
        ew_tidy_half "$3" "$3-a" 1 $((${#files[@]} / 2))
        ew_tidy_half "$3" "$3-b" $((${#files[@]} / 2 + 1)) ${#files[@]}
        ew_tidy_group "$1" "$2" "$3-a"
        ew_tidy_group "$1" "$2" "$3-b"
        return 0
        ;;
    esac
  fi
  [ "$status" -ne 124 ] || return 0
  [ "$status" -eq 0 ] || printf '%s\n' "$said" >&2
  printf "$status %s\n" "${files[@]}" >>"$1/seen"
}

# ew_tidy_half GROUP HALF FIRST LAST: makes HALF of the files FIRST to LAST, counted from one, of a group.
ew_tidy_half() {
  mkdir -p "$2"
  sed -n "$3,$4p" "$1/files" >"$2/files"
  sed -n "$3,$4p" "$1/UnifiedSource.cpp" >"$2/UnifiedSource.cpp"
  sed "s|$1/UnifiedSource|$2/UnifiedSource|g" "$1/compile_commands.json" >"$2/compile_commands.json"
}
export -f ew_tidy_ours ew_tidy_run ew_tidy_group ew_tidy_half

# ew_tidy SECONDS [FILE...]: clang-tidy over the sources among the files (all without any), and a line that says how many it looked at. It is
# over after SECONDS and begins nothing in the last thirty; 0: it takes as long as it takes. Fails where there is a finding.
ew_tidy() {
  local folder=build/tidy end=0 files looked most=24
  [ "$1" -eq 0 ] || { end=$(($(date +%s) + $1)); most=4; }  # a group that is not done in time is not looked at
  shift
  ew_tidy_commands "$folder"
  mapfile -t files < <(ew_tidy_sources "$folder" "$@")
  : >"$folder/seen"
  [ ${#files[@]} -eq 0 ] || ew_tidy_groups "$folder" "$most" "${files[@]}" | tr '\n' '\0' |
    xargs -0 -P "$(nproc)" -I '{}' bash -c 'ew_tidy_group "$@"' _ "$folder" "$end" '{}'
  looked=$(wc -l <"$folder/seen")
  ew_say "clang-tidy looked at $looked of ${#files[@]} sources$([ "$looked" -eq "${#files[@]}" ] || printf '; ./check --tidy looks at all')."
  ! grep -qv '^0 ' "$folder/seen"
}

# The rooms that are clean and are to stay so, as folders: whoever has made one clean adds it.
ew_clean_rooms=(workstation/ plugins/)

# ew_tidy_changed SECONDS: clang-tidy over what changed last in the clean rooms; over all of them where no history tells.
ew_tidy_changed() {
  local changed=() rooms
  rooms=$(IFS='|'; echo "${ew_clean_rooms[*]}")
  mapfile -t changed < <({ ew_changed_files || find "${ew_clean_rooms[@]}" -name '*.cpp' | sort; } | grep -E "^($rooms)")
  if [ ${#changed[@]} -gt 0 ]; then ew_tidy "$1" "${changed[@]}"; else ew_say "Nothing changed in ${ew_clean_rooms[*]}."; fi
}
