#!/usr/bin/env bash
# Makes .venv ready: the locked Python packages, and gantline itself with its compiled core and its player.
#
# Stamps hold a digest of all that went into each part. A digest, and not the age of files, so that
# a deleted source, another branch or a moved checkout is noticed too; a run with nothing to do takes a fraction
# of a second. `tools/setup.sh packages` makes the locked Python packages ready, and nothing else.
set -euo pipefail
cd "$(dirname "$0")/.."

# Without .venv, which make has on the path: its Python may be broken, and is made anew.
PATH=${PATH//"$(pwd -P)/.venv/bin:"/}
python=$(tools/prerequisites.sh)
# The Python itself, not that of an environment which may be active.
python=$("$python" -c 'import sys; print(sys._base_executable)')

venv=.venv
uv=.venv-tools/bin/uv

say() { printf '== %s\n' "$*"; }

digest() { sha256sum | cut -d' ' -f1; }

fresh() { [ -f "$1" ] && [ "$(cat "$1")" = "$2" ]; }

# What both halves rest on: this place and this Python.
place() {
    pwd
    "$python" -c 'import sys; print(sys.version, sys.base_prefix)'
}

tools_digest() { { place; cat requirements/uv.txt; } | digest; }

packages_digest() { { place; cat requirements/uv.txt requirements/dev.txt; } | digest; }

# All inputs of the compiled core.
core_digest() {
    {
        place
        rustc --version --verbose
        printf '%s\n' "${RUSTFLAGS:-}"
        find crates Cargo.toml Cargo.lock pyproject.toml -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum
    } | digest
}

# What came of them: a library that was replaced or removed is built again.
library_digest() { sha256sum python/gantline/_core*.so 2>/dev/null | digest; }

# uv does not read pip's settings: hand on the package index, extra indexes, folders of wheels and certificates.
pip_setting() {
    .venv-tools/bin/python -m pip config list | sed -nE "s/^[^=]*\.$1='(.*)'\$/\1/p" | tail -n 1
}

as_pip_does() {
    local value
    value=$(pip_setting index-url) && [ -n "$value" ] && export UV_DEFAULT_INDEX="${UV_DEFAULT_INDEX:-$value}"
    value=$(pip_setting extra-index-url) && [ -n "$value" ] && export UV_INDEX="${UV_INDEX:-$value}"
    value=$(pip_setting find-links) && [ -n "$value" ] && [ -e "$value" ] && export UV_FIND_LINKS="${UV_FIND_LINKS:-$value}"
    value=$(pip_setting cert) && [ -n "$value" ] && export SSL_CERT_FILE="${SSL_CERT_FILE:-$value}"
    return 0
}

install_uv() {
    say "uv, pinned, into .venv-tools"
    rm -rf .venv-tools
    "$python" -m venv .venv-tools
    .venv-tools/bin/python -m pip install --quiet --disable-pip-version-check --no-user \
        --require-hashes --only-binary :all: -r requirements/uv.txt
}

install_packages() {
    say "locked Python packages into $venv"
    rm -f "$venv/.stamp-packages" "$venv/.stamp-core"
    as_pip_does
    "$uv" venv --quiet --no-config --clear --no-python-downloads --python "$python" "$venv"
    "$uv" pip sync --quiet --no-config --python "$venv" --require-hashes requirements/dev.txt
}

build_core() {
    local log="$venv/build.log"
    say "gantline and its core, by cargo"
    rm -f "$venv/.stamp-core"
    VIRTUAL_ENV="$PWD/$venv" PATH="$PWD/.venv-tools/bin:$PATH" UV_NO_CONFIG=1 UV_OFFLINE=1 \
        "$venv/bin/maturin" develop --release --locked --uv >"$log" 2>&1 || { cat "$log" >&2; return 1; }
}

# All inputs of the player: npm's packages, and the sources.
node_digest() { { pwd; node --version; cat viewer/package.json viewer/package-lock.json; } | digest; }

player_digest() {
    {
        node_digest
        find viewer -path viewer/node_modules -prune -o -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum
        cat python/gantline/viewer/static/* 2>/dev/null | digest
    } | digest
}

install_node_packages() {
    say "locked npm packages into viewer/node_modules"
    rm -f viewer/node_modules/.stamp-packages viewer/node_modules/.stamp-player
    # What builds the player is for development, and left out where NODE_ENV says production.
    npm ci --prefix viewer --include=dev --no-audit --no-fund --loglevel error
}

build_player() {
    say "the player, by vite"
    npm --prefix viewer run build --silent -- --logLevel error
}

packages=$(packages_digest)
# Without the lock: lints need not wait until the core is compiled, which holds it meanwhile.
if [ "${1:-}" = packages ] && fresh "$venv/.stamp-packages" "$packages"; then exit 0; fi

# Two set-ups at a time would undo each other.
exec 9>.setup.lock
command -v flock >/dev/null && flock 9

if ! fresh "$venv/.stamp-packages" "$packages"; then
    fresh .venv-tools/.stamp "$(tools_digest)" && [ -x "$uv" ] || install_uv
    tools_digest >.venv-tools/.stamp
    install_packages
    echo "$packages" >"$venv/.stamp-packages"
fi
[ "${1:-}" != packages ] || exit 0

# Taken before the build, so that a source edited meanwhile is not taken for built.
core=$(core_digest)
if ! fresh "$venv/.stamp-core" "$core $(library_digest)"; then
    # Without the lock: a cache of compilers may leave a server behind, which would hold it for good.
    build_core 9>&-
    echo "$core $(library_digest)" >"$venv/.stamp-core"
fi

node_packages=$(node_digest)
if ! fresh viewer/node_modules/.stamp-packages "$node_packages"; then
    install_node_packages
    echo "$node_packages" >viewer/node_modules/.stamp-packages
fi

if ! fresh viewer/node_modules/.stamp-player "$(player_digest)"; then
    build_player
    player_digest >viewer/node_modules/.stamp-player
fi
