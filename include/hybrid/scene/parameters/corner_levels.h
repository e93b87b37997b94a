// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::scene
{
  /// Largest Mesh/Corner levels: cells at a corner are a millionth of the others then.
  constexpr int most_corner_levels = 20;
} // namespace hybrid::scene
