#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Sources are laid out by .clang-format. Other versions lay out differently, so only the pinned one can judge;
# exit code 77 (skipped) where it is not installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

pinned_version=14
for formatter in "clang-format-$pinned_version" clang-format; do
  if command -v "$formatter" >/dev/null && "$formatter" --version | grep -q "version $pinned_version\."; then
    find include src tests \( -name '*.h' -o -name '*.cc' \) -exec "$formatter" --dry-run --Werror {} +
    exit
  fi
done
exit 77
