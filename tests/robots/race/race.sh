#!/usr/bin/env bash
# The kernels of five robots against Pinocchio 4.1: race.sh [FOLDER for what is installed and built]. Installs a compiler, Eigen,
# urdfdom, and Pinocchio with the robots' files; its compiler takes four to nine minutes.
set -euo pipefail
cd "$(dirname "$0")"
folder=$(realpath -m "${1:-target/pinocchio}")
mkdir -p "$folder"

packages=(g++ libeigen3-dev liburdfdom-headers-dev liburdfdom-dev python3-venv)
dpkg -s "${packages[@]}" >/dev/null 2>&1 || apt-get install -y -qq "${packages[@]}" >/dev/null
if ! [ -d "$folder/python" ]; then
    python3 -m venv "$folder/python"
    "$folder/python/bin/pip" install --quiet 'pin==4.1.0' 'example-robot-data==6.0.0'
fi
prefix=$(echo "$folder"/python/lib/python3*/site-packages/cmeel.prefix)
if ! [ -x "$folder/pinocchio" ]; then
    g++ -std=c++17 -O3 -DNDEBUG -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 \
        -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -I"$prefix/include" -I/usr/include/urdfdom_headers -I/usr/include/eigen3 \
        pinocchio.cpp -o "$folder/pinocchio" -L"$prefix/lib" -lpinocchio_default -lpinocchio_parsers \
        -Wl,-rpath,"$prefix/lib" -Wl,-rpath-link,"$prefix/lib"
fi
cargo build --release --quiet
"${CARGO_TARGET_DIR:-target}/release/race" "$folder/pinocchio" "$prefix/share/example-robot-data/robots"
