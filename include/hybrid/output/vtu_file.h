// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hybrid::output
{
  /// A .vtu file that is written: text and arrays, one after the other.
  class VtuFile
  {
  public:
    virtual ~VtuFile() = default;

    virtual void add_text(std::string_view text) = 0;

    /// An array as VTK wants it: in base64 first how many zlib blocks follow, how large all but a
    /// smaller last one are before compression, that last one, and each of them now; then they.
    virtual void add_array(const void *data, std::size_t n_bytes) = 0;
  };


  /// The whole file as a text.
  class VtuText final : public VtuFile
  {
  public:
    void add_text(std::string_view text) override;
    void add_array(const void *data, std::size_t n_bytes) override;

    const std::string &content() const
    {
      return xml;
    }

  private:
    std::string xml;
  };


  /// One zlib block, as fast as it goes: pictures lose half of their size, and little of it more
  /// with other levels.
  std::vector<unsigned char> zlib_block(const void *data, std::size_t n_bytes);
} // namespace hybrid::output
