#!/usr/bin/env bash
# Builds the container image and tries it: matches with --sandbox strict, as its own user and as in
# docs/tournament-cluster.md, and the program for workers of a cluster.
#
#   scripts/try_container.sh [TAG]
#
# Needs Docker or Podman; exit status 2 if neither runs here.
set -euo pipefail
cd "$(dirname "$0")/.."
image=${1:-rcj-challenges:try}

engine=""
for candidate in docker podman; do
  if "$candidate" info >/dev/null 2>&1; then
    engine=$candidate
    break
  fi
done
[ -n "$engine" ] || { echo "neither Docker nor Podman runs here" >&2; exit 2; }

folder=$(mktemp -d "${TMPDIR:-/tmp}/rcj-container.XXXXXX")
trap 'rm -rf "$folder"' EXIT

# play OPTION…: play some seconds in a container with these options.
play() {
  "$engine" run --rm --init "$@" "$image" run match --duration 5 --sandbox strict --json >"$folder/printed.json"
  python3 - "$folder/printed.json" <<'PYTHON'
import json, pathlib, sys

result = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
assert result["complete"] is True and not result["faults"], result
print("played", result["simulated_s"], "s with", result["sandbox"])
PYTHON
}

"$engine" build --tag "$image" .
echo "$(($("$engine" image inspect --format '{{.Size}}' "$image") / 1000000)) MB"
play
play --user "$(id -u):$(id -g)" -v "$folder:/work"
ls "$folder"/runs/*/result.json
"$engine" run --rm --init --entrypoint dask "$image" --version
