// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/base64.h>

#include <cstdint>

namespace hybrid::output
{
  namespace
  {
    void append_group(std::string &text, const std::uint32_t group)
    {
      static constexpr char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      for (int shift = 18; shift >= 0; shift -= 6)
        text += digits[(group >> shift) & 63];
    }
  } // namespace



  void append_base64(std::string &text, const void *data, const std::size_t n_bytes)
  {
    const auto *bytes      = static_cast<const unsigned char *>(data);
    const auto  group_from = [bytes, n_bytes](const std::size_t i) {
      std::uint32_t group = 0;
      for (std::size_t k = i; k < i + 3; ++k)
        group = (group << 8) | (k < n_bytes ? bytes[k] : 0u);
      return group;
    };
    for (std::size_t i = 0; i < n_bytes; i += 3)
      append_group(text, group_from(i));
    for (std::size_t k = 0; k < (3 - n_bytes % 3) % 3; ++k)
      text[text.size() - 1 - k] = '=';
  }
} // namespace hybrid::output
