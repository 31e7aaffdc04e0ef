#!/usr/bin/env bash
# What is measured of robots' files: `urdf.sh compare|first|trip [NAME ..]`. Installs the package of robots and Pinocchio.
set -euo pipefail
cd "$(dirname "$0")/../../.."
subject="${1:?which: compare, first or trip}"
shift

target="${CARGO_TARGET_DIR:-target}"
python="$target/robots/bin/python"
if ! [ -x "$python" ]; then
    python3 -m venv "$target/robots"
    "$target/robots/bin/pip" install --quiet numpy pin==4.1.0 example-robot-data
fi
cargo build --quiet --release -p sim
sim="$PWD/$target/release/sim"
case "$target" in /*) sim="$target/release/sim" ;; esac

case "$subject" in
    compare) exec "$python" tests/robots/urdf/compare.py "$sim" "$@" ;;
    first | trip) exec "$python" tests/robots/urdf/runs.py "$sim" "$subject" "$@" ;;
    *) echo "no subject is called $subject" >&2 && exit 2 ;;
esac
