// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/ownership.h>

#include <algorithm>

namespace hybrid::continuum
{
  Ownership::Ownership(std::vector<int> mine, const std::size_t n, const MPI_Comm communicator)
    : own(std::move(mine))
    , comm(communicator)
  {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &ranks);
    if (ranks == 1)
      return;
    const int count = static_cast<int>(own.size());
    counts.resize(ranks);
    offsets.assign(ranks, 0);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
    for (int r = 1; r < ranks; ++r)
      offsets[r] = offsets[r - 1] + counts[r - 1];
    if (rank == 0)
      unknown_of.resize(n);
    MPI_Gatherv(own.data(),
                count,
                MPI_INT,
                unknown_of.data(),
                counts.data(),
                offsets.data(),
                MPI_INT,
                0,
                comm);
  }



  std::vector<int> Ownership::times(const std::vector<int> &numbers, const int width) const
  {
    std::vector<int> result = numbers;
    for (int &number : result)
      number *= width;
    return result;
  }



  void Ownership::gather(const std::vector<double> &mine, const int width, std::vector<double> &all)
  {
    if (is_alone())
      return;
    const std::vector<int> lengths = times(counts, width), starts = times(offsets, width);
    sent.resize(unknown_of.size() * width);
    MPI_Gatherv(mine.data(),
                static_cast<int>(own.size()) * width,
                MPI_DOUBLE,
                sent.data(),
                lengths.data(),
                starts.data(),
                MPI_DOUBLE,
                0,
                comm);
    all.resize(sent.size());
    for (std::size_t k = 0; k < unknown_of.size(); ++k)
      std::copy_n(&sent[k * width], width, &all[static_cast<std::size_t>(unknown_of[k]) * width]);
  }



  void
  Ownership::scatter(const std::vector<double> &all, const int width, std::vector<double> &mine)
  {
    if (is_alone())
      return;
    const std::vector<int> lengths = times(counts, width), starts = times(offsets, width);
    sent.resize(unknown_of.size() * width);
    for (std::size_t k = 0; k < unknown_of.size(); ++k)
      std::copy_n(&all[static_cast<std::size_t>(unknown_of[k]) * width], width, &sent[k * width]);
    mine.resize(own.size() * width);
    MPI_Scatterv(sent.data(),
                 lengths.data(),
                 starts.data(),
                 MPI_DOUBLE,
                 mine.data(),
                 static_cast<int>(mine.size()),
                 MPI_DOUBLE,
                 0,
                 comm);
  }
} // namespace hybrid::continuum
