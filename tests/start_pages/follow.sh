#!/usr/bin/env bash
# follow.sh PROGRAM_FOLDER [PAGE...]: runs the commands of the start pages (fenced blocks marked sh), one after another, as a stranger
# would: in a fresh home and a fresh folder. PROGRAM_FOLDER holds `echoweave`, which takes the place of ./run. Fails at the first command
# that fails. A sweep that an earlier page made with the same command is not made twice.
set -euo pipefail
programs=$(cd "${1:?usage: follow.sh PROGRAM_FOLDER [PAGE...]}" && pwd)
shift
top=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
pages=("$@")
if [ ${#pages[@]} -eq 0 ]; then
  for page in scan volume case lesson tracker; do pages+=("$top/resources/docs/start/first-$page.md"); done
fi

place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir -p "$place/home" "$place/repository"
mkdir -m 0700 "$place/runtime"
ln -s "$top/cases" "$top/resources" "$place/repository/"
cd "$place/repository"
unset ECHOWEAVE_CASES ECHOWEAVE_LIBRARY ECHOWEAVE_CACHE ECHOWEAVE_PRESETS ECHOWEAVE_LANGUAGE
export HOME=$place/home XDG_CONFIG_HOME=$place/home/.config XDG_DATA_HOME=$place/home/.local/share XDG_CACHE_HOME=$place/home/.cache
export XDG_RUNTIME_DIR=$place/runtime ECHOWEAVE_RESOURCES=$top/resources

# The commands of a page, one a line.
commands() { awk '/^ *```sh *$/ { inside = 1; next } /^ *```/ { inside = 0 } inside { sub(/^ +/, ""); if (length) print }' "$1"; }

declare -A made
count=0
for page in "${pages[@]}"; do
  name=$(basename "$page")
  found=$(commands "$page")
  if [ -z "$found" ]; then
    echo "$name: no command is marked sh" >&2
    exit 1
  fi
  while IFS= read -r command; do
    if [ -n "${made[$command]-}" ]; then continue; fi
    made[$command]=yes
    count=$((count + 1))
    began=$SECONDS
    if ! bash -euo pipefail -c "${command/.\/run /\"$programs/echoweave\" }" </dev/null >"$place/said" 2>&1; then
      echo "$name: this command fails: $command" >&2
      tail -n 20 "$place/said" >&2
      exit 1
    fi
    echo "$name: $((SECONDS - began)) s: $command"
  done <<<"$found"
done

# What the pages say they leave behind.
for file in first-scan.png first/stitched/volume.mha first/slice.png first/sheets.pdf; do
  [ ${#pages[@]} -lt 5 ] || [ -s "$file" ] || { echo "no page made $file" >&2; exit 1; }
done
echo "$count commands of ${#pages[@]} pages, $SECONDS s"
