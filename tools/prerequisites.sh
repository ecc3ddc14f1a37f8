#!/usr/bin/env bash
# Says in one sentence what this machine lacks to build gantline; prints the chosen Python when all is there.
set -euo pipefail

least_python=3.11
least_node=20.19
least_rust=$(sed -nE 's/^rust-version = "([0-9.]+)"$/\1/p' "$(dirname "$0")/../Cargo.toml")

missing=()

# at_least FOUND LEAST: is version FOUND not older than LEAST?
at_least() {
    [ "$(printf '%s\n%s\n' "$2" "$1" | sort -V | head -n 1)" = "$2" ]
}

python=
for candidate in ${PYTHON:-python3 python3.14 python3.13 python3.12 python3.11}; do
    found=$("$candidate" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null) || continue
    if at_least "$found" "$least_python"; then
        python=$candidate
        break
    fi
done
if [ -z "$python" ]; then
    found=$("${PYTHON:-python3}" -c 'import platform; print(platform.python_version())' 2>/dev/null) || found=
    missing+=("Python $least_python or newer (found ${found:-none})")
elif ! "$python" -c 'import ensurepip, venv' 2>/dev/null; then
    missing+=("Python's venv module (a package such as python3-venv)")
fi

if ! command -v cc >/dev/null && ! command -v gcc >/dev/null && ! command -v clang >/dev/null; then
    missing+=("a C toolchain (a package such as build-essential)")
fi

for tool in cargo rustc; do
    found=$("$tool" --version 2>/dev/null | cut -d' ' -f2) || found=
    if [ -z "$found" ] || ! at_least "$found" "$least_rust"; then
        missing+=("Rust $least_rust or newer with $tool (found ${found:-none})")
        break
    fi
done

found=$(node --version 2>/dev/null | sed 's/^v//') || found=
if [ -z "$found" ] || ! at_least "$found" "$least_node" || ! command -v npm >/dev/null; then
    missing+=("Node $least_node or newer with npm (found ${found:-none})")
fi

if [ ${#missing[@]} -gt 0 ]; then
    sentence=${missing[0]}
    for item in "${missing[@]:1}"; do
        sentence="$sentence; $item"
    done
    echo "gantline cannot be built here yet; please install: $sentence." >&2
    exit 1
fi
echo "$python"
