// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid
{
  /// Let vectors of 1 MB and more go back to the system at once. SuperLU, which comes with deal.II,
  /// has glibc keep all memory there ever was as soon as it is loaded: no block is mapped, no end
  /// of the heap is given back.
  void return_large_vectors();
} // namespace hybrid
