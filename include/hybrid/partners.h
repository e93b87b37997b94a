// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/process_group.h>

#include <mpi.h>

namespace hybrid
{
  /// The processes of an MPI communicator that compute the blocks together.
  class Partners final : public dda::ProcessGroup
  {
  public:
    explicit Partners(MPI_Comm of_all);

    int count() const override
    {
      return size;
    }

    int rank() const override
    {
      return number;
    }

    bool all(bool mine) const override;
    void gather(std::vector<double> &values, const std::vector<std::size_t> &begin) const override;
    void gather_shares(void *things, std::size_t n, std::size_t bytes) const override;
    void spread(int from, double *values, std::size_t n) const override;

  private:
    const MPI_Comm           communicator;
    int                      size = 1, number = 0;
    mutable std::vector<int> counts, places; ///< work: of the parts, as MPI wants them
  };
} // namespace hybrid
