// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/partners.h>

#include <algorithm>

namespace hybrid
{
  Partners::Partners(const MPI_Comm of_all)
    : communicator(of_all)
  {
    MPI_Comm_size(communicator, &size);
    MPI_Comm_rank(communicator, &number);
    counts.resize(size);
    places.resize(size);
  }



  bool Partners::all(const bool mine) const
  {
    int agreed = mine ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &agreed, 1, MPI_INT, MPI_MIN, communicator);
    return agreed != 0;
  }



  void Partners::gather(std::vector<double> &values, const std::vector<std::size_t> &begin) const
  {
    for (int p = 0; p < size; ++p)
      {
        places[p] = static_cast<int>(begin[p]);
        counts[p] = static_cast<int>(begin[p + 1] - begin[p]);
      }
    MPI_Allgatherv(MPI_IN_PLACE,
                   0,
                   MPI_DATATYPE_NULL,
                   values.data(),
                   counts.data(),
                   places.data(),
                   MPI_DOUBLE,
                   communicator);
  }



  void Partners::gather_shares(void *things, const std::size_t n, const std::size_t bytes) const
  {
    for (int p = 0; p < size; ++p)
      {
        places[p] = static_cast<int>(bytes * share_begin(n, p));
        counts[p] = static_cast<int>(bytes * share_begin(n, p + 1)) - places[p];
      }
    MPI_Allgatherv(MPI_IN_PLACE,
                   0,
                   MPI_DATATYPE_NULL,
                   things,
                   counts.data(),
                   places.data(),
                   MPI_BYTE,
                   communicator);
  }



  void Partners::spread(const int from, double *values, const std::size_t n) const
  {
    constexpr std::size_t most = std::size_t{1} << 27; // at once: MPI counts by int
    for (std::size_t begin = 0; begin < n; begin += most)
      MPI_Bcast(values + begin,
                static_cast<int>(std::min(most, n - begin)),
                MPI_DOUBLE,
                from,
                communicator);
  }
} // namespace hybrid
