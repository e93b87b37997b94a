// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/process_group.h>

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace hybrid::test
{
  /// Threads in place of processes, for tests without MPI.
  class ThreadGroup
  {
  public:
    explicit ThreadGroup(const int n)
      : size(n)
    {}

    /// Let each do @p work with its own view of the group.
    void run(const std::function<void(const dda::ProcessGroup &)> &work)
    {
      std::vector<std::thread> threads;
      for (int rank = 0; rank < size; ++rank)
        threads.emplace_back([this, rank, &work] { work(Member(*this, rank)); });
      for (std::thread &thread : threads)
        thread.join();
    }

    /// Doubles that one has got from others, so far.
    std::size_t received() const
    {
      return n_received;
    }

  private:
    class Member : public dda::ProcessGroup
    {
    public:
      Member(ThreadGroup &of, const int number)
        : group(of)
        , mine(number)
      {}

      int count() const override
      {
        return group.size;
      }

      int rank() const override
      {
        return mine;
      }

      bool all(const bool value) const override
      {
        group.wait([&] { group.agreed = true; });
        {
          const std::lock_guard<std::mutex> lock(group.mutex);
          group.agreed = group.agreed && value;
        }
        bool result = false;
        group.wait();
        result = group.agreed;
        group.wait();
        return result;
      }

      void gather(std::vector<double> &values, const std::vector<std::size_t> &begin) const override
      {
        group.wait([&] { group.board.assign(values.size(), 0.); });
        std::copy(values.begin() + begin[mine],
                  values.begin() + begin[mine + 1],
                  group.board.begin() + begin[mine]);
        group.wait([&] { group.n_received += values.size() * (group.size - 1) / group.size; });
        values = group.board;
        group.wait();
      }

      void gather_shares(void *things, const std::size_t n, const std::size_t bytes) const override
      {
        group.wait([&] { group.bytes.assign(n * bytes, 0); });
        const auto [first, last] = dda::own_share(n, this);
        std::memcpy(group.bytes.data() + first * bytes,
                    static_cast<char *>(things) + first * bytes,
                    (last - first) * bytes);
        group.wait();
        std::memcpy(things, group.bytes.data(), n * bytes);
        group.wait();
      }

      void spread(const int from, double *values, const std::size_t n) const override
      {
        group.wait([&] { group.board.resize(n); });
        if (from == mine)
          std::copy(values, values + n, group.board.begin());
        group.wait([&] { group.n_received += n; });
        std::copy(group.board.begin(), group.board.end(), values);
        group.wait();
      }

    private:
      ThreadGroup &group;
      const int    mine;
    };

    /// Until all are here; the last one does @p work before they go on.
    void wait(const std::function<void()> &work = [] {})
    {
      std::unique_lock<std::mutex> lock(mutex);
      const int                    round = rounds;
      if (++here == size)
        {
          work();
          here = 0;
          ++rounds;
          all_here.notify_all();
        }
      else
        all_here.wait(lock, [&] { return rounds != round; });
    }

    const int               size;
    std::mutex              mutex;
    std::condition_variable all_here;
    int                     here = 0, rounds = 0;
    bool                    agreed = true;
    std::vector<double>     board;
    std::vector<char>       bytes;
    std::size_t             n_received = 0;
  };
} // namespace hybrid::test
