// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hybrid::dda
{
  /// Where the steps of blocks spent their wall time, summed; the parts do not overlap [s].
  struct PartTimes
  {
    double search           = 0.; ///< of contacts
    double springs          = 0.; ///< collected, connected and evaluated
    double assembly         = 0.; ///< of tangent and preconditioner, with the copies of its rows
    double factors          = 0.; ///< of sparse matrices, made anew
    double products         = 0.; ///< of the linear solver: matrix, sweeps, substitution
    double surface_products = 0.; ///< of the bedrock's dense surface stiffness, in residuals

    PartTimes &operator+=(const PartTimes &other)
    {
      search += other.search;
      springs += other.springs;
      assembly += other.assembly;
      factors += other.factors;
      products += other.products;
      surface_products += other.surface_products;
      return *this;
    }
  };

  /// For the checkpoint.
  template <typename Archive>
  void serialize(Archive &archive, PartTimes &times)
  {
    archive(times.search,
            times.springs,
            times.assembly,
            times.factors,
            times.products,
            times.surface_products);
  }
} // namespace hybrid::dda
