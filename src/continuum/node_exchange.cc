// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/node_exchange.h>
#include <hybrid/continuum/portion.h>

#include <algorithm>
#include <numeric>

namespace hybrid::continuum
{
  namespace
  {
    std::vector<int> starts(const std::vector<int> &counts, const int width)
    {
      std::vector<int> result(counts.size(), 0);
      for (std::size_t r = 1; r < counts.size(); ++r)
        result[r] = result[r - 1] + width * counts[r - 1];
      return result;
    }



    std::vector<int> times(std::vector<int> counts, const int width)
    {
      for (int &count : counts)
        count *= width;
      return counts;
    }



    /// Lists for each rank, one after the other.
    struct Lists
    {
      std::vector<int> numbers, counts;
    };



    /// What the others have for this rank.
    Lists swapped(const Lists &mine, const MPI_Comm comm)
    {
      Lists result;
      result.counts.resize(mine.counts.size());
      MPI_Alltoall(mine.counts.data(), 1, MPI_INT, result.counts.data(), 1, MPI_INT, comm);
      const std::vector<int> from = starts(mine.counts, 1), to = starts(result.counts, 1);
      result.numbers.resize(to.back() + result.counts.back());
      MPI_Alltoallv(mine.numbers.data(),
                    mine.counts.data(),
                    from.data(),
                    MPI_INT,
                    result.numbers.data(),
                    result.counts.data(),
                    to.data(),
                    MPI_INT,
                    comm);
      return result;
    }



    /// Nodes by the rank that keeps their owners. @param nodes ascending
    Lists by_keeper(const std::vector<int> &nodes, const std::size_t n, const int ranks)
    {
      Lists lists{nodes, std::vector<int>(ranks, 0)};
      for (const int node : nodes)
        ++lists.counts[node / portion_size(n, ranks)];
      return lists;
    }



    /// Owners of @p nodes, which are ascending.
    std::vector<int> find_owners(const std::vector<int> &mine,
                                 const std::vector<int> &nodes,
                                 const std::size_t       n,
                                 const MPI_Comm          comm)
    {
      int rank = 0, ranks = 1;
      MPI_Comm_rank(comm, &rank);
      MPI_Comm_size(comm, &ranks);
      const Portion    kept = portion_of(n, rank, ranks);
      std::vector<int> owner(kept.size(), -1);
      const Lists      owned = swapped(by_keeper(mine, n, ranks), comm);
      for (int r = 0, k = 0; r < ranks; ++r)
        for (const int end = k + owned.counts[r]; k < end; ++k)
          owner[owned.numbers[k] - kept.begin] = r;
      Lists questions = swapped(by_keeper(nodes, n, ranks), comm);
      for (int &number : questions.numbers)
        number = owner[number - kept.begin];
      return swapped(questions, comm).numbers;
    }
  } // namespace



  NodeExchange::NodeExchange(const std::vector<int> &mine,
                             const std::vector<int> &wanted,
                             const std::size_t       n,
                             const MPI_Comm          communicator)
    : comm(communicator)
  {
    int ranks = 1;
    MPI_Comm_size(comm, &ranks);
    received.resize(wanted.size());
    std::iota(received.begin(), received.end(), 0);
    std::sort(received.begin(), received.end(), [&](const int a, const int b) {
      return wanted[a] < wanted[b];
    });
    std::vector<int> nodes;
    for (const int place : received)
      nodes.push_back(wanted[place]);
    std::vector<int> owner(wanted.size());
    {
      const std::vector<int> owners = find_owners(mine, nodes, n, comm);
      for (std::size_t k = 0; k < owners.size(); ++k)
        owner[received[k]] = owners[k];
    }
    std::stable_sort(received.begin(), received.end(), [&](const int a, const int b) {
      return owner[a] < owner[b];
    });
    Lists asked{{}, std::vector<int>(ranks, 0)};
    for (const int place : received)
      {
        asked.numbers.push_back(wanted[place]);
        ++asked.counts[owner[place]];
      }
    n_received       = asked.counts;
    const Lists told = swapped(asked, comm);
    n_sent           = told.counts;
    for (const int node : told.numbers)
      sent.push_back(
        static_cast<int>(std::lower_bound(mine.begin(), mine.end(), node) - mine.begin()));
  }



  void NodeExchange::bring(const double *mine, const int width, double *wanted) const
  {
    std::vector<double> out(sent.size() * width), in(received.size() * width);
    for (std::size_t k = 0; k < sent.size(); ++k)
      std::copy_n(mine + static_cast<std::size_t>(sent[k]) * width, width, &out[k * width]);
    const std::vector<int> out_counts = times(n_sent, width), in_counts = times(n_received, width);
    MPI_Alltoallv(out.data(),
                  out_counts.data(),
                  starts(n_sent, width).data(),
                  MPI_DOUBLE,
                  in.data(),
                  in_counts.data(),
                  starts(n_received, width).data(),
                  MPI_DOUBLE,
                  comm);
    for (std::size_t k = 0; k < received.size(); ++k)
      std::copy_n(&in[k * width], width, wanted + static_cast<std::size_t>(received[k]) * width);
  }
} // namespace hybrid::continuum
