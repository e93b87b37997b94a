#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# ./setup.sh                        install what is missing, then configure and build the program (build/release/hybrid)
# ./setup.sh run PARAMS.prm [args]  the same, then run a scene
# ./setup.sh benchmark [args]       the same with the kernels, then times them and the scenes of `hybrid benchmark`
# ./setup.sh test [--long]          the same with the tests, then every test, also under address and undefined-behaviour
#                                   sanitizers; --long adds the long runs
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

packages=(build-essential cmake ninja-build git libdeal.ii-dev libgmsh-dev libeigen3-dev
          libsuitesparse-dev libopenblas-dev libgtest-dev zlib1g-dev libhdf5-openmpi-dev
          nlohmann-json3-dev libcli11-dev
          python3 python3-h5py python3-jinja2 python3-matplotlib python3-scipy python3-shapely python3-tabulate
          python3-allpairspy python3-hypothesis)

# For `test` alone: files for ParaView are read, tools are tested (films as mp4 with ffmpeg, pages of runs in a browser),
# pages of headers and documents are made.
test_packages=(python3-vtk9 python3-pytest ffmpeg chromium chromium-driver python3-selenium doxygen)

# For `test --long` alone (680 MB): the workflow of a study is run.
long_test_packages=(snakemake)

# Modules whose unit tests run under the sanitizers, and whether a leak is an error:
# where MPI is linked, the leak checker reports MPI's own.
sanitized_modules=(dda restart scene)
declare -A detect_leaks=([dda]=1 [restart]=1 [scene]=0)

# BLAS results depend on its number of threads; Open MPI refuses root (containers) unless told.
export OPENBLAS_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

usage() {
  sed -n '4,8s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
}

install_debian_packages() {
  local missing=() package
  for package in "${packages[@]}"; do
    [[ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)" == installed ]] ||
      missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return

  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "error: not root and no sudo; as root run: apt-get install ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  echo "installing ${missing[*]}"
  "${as_root[@]}" apt-get update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# Elsewhere than on Debian: say what is missing, install nothing.
name_missing_parts() {
  local missing=() tool header
  for tool in c++ cmake ninja git /usr/bin/python3; do
    command -v "$tool" >/dev/null || missing+=("$tool")
  done
  if command -v c++ >/dev/null; then
    for header in deal.II/base/config.h gmsh.h eigen3/Eigen/Core suitesparse/cholmod.h gtest/gtest.h \
      nlohmann/json.hpp CLI/CLI.hpp zlib.h; do
      printf '#if !__has_include(<%s>)\n#error\n#endif\n' "$header" | c++ -E -x c++ - >/dev/null 2>&1 ||
        missing+=("<$header>")
    done
  fi
  if ! /usr/bin/python3 -c 'import h5py, jinja2, matplotlib, scipy, shapely, allpairspy, hypothesis' 2>/dev/null; then
    missing+=("modules h5py, jinja2, matplotlib, scipy, shapely, allpairspy and hypothesis of /usr/bin/python3")
  fi
  if [[ ${#missing[@]} -gt 0 ]]; then
    printf 'error: this is not a Debian system, so nothing is installed. Missing:\n' >&2
    printf '  %s\n' "${missing[@]}" >&2
    printf 'On Debian 12 these packages provide them: %s\n' "${packages[*]}" >&2
    exit 1
  fi
}

install_packages() {
  if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then
    install_debian_packages
  else
    name_missing_parts
  fi
}

# configure_and_build PRESET [TARGET...]
configure_and_build() {
  local preset="$1"
  shift
  (
    cd "$root"
    cmake --preset "$preset" >"$root/build/$preset.log" 2>&1 || { cat "$root/build/$preset.log" >&2; exit 1; }
    cmake --build "build/$preset" ${1:+--target "$@"}
  )
}

run_ctest() {
  local preset="$1"
  shift
  ctest --test-dir "$root/build/$preset" --output-on-failure --no-tests=error "$@"
}

run_tests() {
  local exclude=(--label-exclude '^long$')
  [[ "${1:-}" == --long ]] && exclude=()

  run_ctest release -j "$(nproc)" "${exclude[@]}"

  configure_and_build sanitize "${sanitized_modules[@]/%/_unit_tests}"
  local module
  for module in "${sanitized_modules[@]}"; do
    ASAN_OPTIONS="detect_leaks=${detect_leaks[$module]}" UBSAN_OPTIONS=print_stacktrace=1 \
      run_ctest sanitize --tests-regex "^unit\\.$module\$"
  done
  echo "all tests passed"
}

command="${1:-build}"
[[ $# -gt 0 ]] && shift
case "$command" in
  build) [[ $# -eq 0 ]] || usage ;;
  run)   [[ $# -ge 1 ]] || usage ;;
  benchmark) ;;
  test)  [[ $# -eq 0 || "$*" == --long ]] || usage ;;
  *)     usage ;;
esac

[[ "$command" == test ]] && packages+=("${test_packages[@]}")
[[ "$command" == test && "$*" == --long ]] && packages+=("${long_test_packages[@]}")
[[ "$command" == benchmark ]] && packages+=(libbenchmark-dev)
install_packages
mkdir -p "$root/build"
if [[ "$command" == test ]]; then
  configure_and_build release
elif [[ "$command" == benchmark ]]; then
  configure_and_build release hybrid kernels
else
  configure_and_build release hybrid
fi

case "$command" in
  run)  exec "$root/build/release/hybrid" "$@" ;;
  benchmark)
    "$root/build/release/tests/benchmarks/kernels"
    exec "$root/build/release/hybrid" benchmark "$@"
    ;;
  test) run_tests "$@" ;;
esac
