// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cerrno>
#include <cstdlib>

/// Counts what this process asks for memory, Eigen's requests and those of the linear solvers too:
/// malloc and its kin of the GNU C library are replaced by ones that count. For one source of a
/// program; not with sanitizers, which replace them as well.
namespace hybrid::test
{
  inline std::atomic<long> memory_requests{0}; ///< so far
} // namespace hybrid::test

// The GNU C library's own allocator under its other names.
extern "C"
{
  void *__libc_malloc(std::size_t);
  void *__libc_calloc(std::size_t, std::size_t);
  void *__libc_realloc(void *, std::size_t);
  void *__libc_memalign(std::size_t, std::size_t);

  void *malloc(const std::size_t size)
  {
    ++hybrid::test::memory_requests;
    return __libc_malloc(size);
  }

  void *calloc(const std::size_t number, const std::size_t size)
  {
    ++hybrid::test::memory_requests;
    return __libc_calloc(number, size);
  }

  void *realloc(void *memory, const std::size_t size)
  {
    ++hybrid::test::memory_requests;
    return __libc_realloc(memory, size);
  }

  void *aligned_alloc(const std::size_t alignment, const std::size_t size)
  {
    ++hybrid::test::memory_requests;
    return __libc_memalign(alignment, size);
  }

  int posix_memalign(void **memory, const std::size_t alignment, const std::size_t size)
  {
    ++hybrid::test::memory_requests;
    *memory = __libc_memalign(alignment, size);
    return *memory != nullptr ? 0 : ENOMEM;
  }
}
