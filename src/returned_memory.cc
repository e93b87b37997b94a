// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/returned_memory.h>

#include <malloc.h>

namespace hybrid
{
  void return_large_vectors()
  {
    constexpr int megabyte = 1 << 20, blocks = 1 << 16;
    mallopt(M_MMAP_MAX, blocks);
    mallopt(M_MMAP_THRESHOLD, megabyte);
    mallopt(M_TRIM_THRESHOLD, megabyte);
  }
} // namespace hybrid
