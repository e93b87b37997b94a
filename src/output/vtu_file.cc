// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/base64.h>
#include <hybrid/output/vtu_file.h>

#include <stdexcept>
#include <zlib.h>

namespace hybrid::output
{
  void VtuText::add_text(const std::string_view text)
  {
    xml += text;
  }



  void VtuText::add_array(const void *data, const std::size_t n_bytes)
  {
    const auto          block    = zlib_block(data, n_bytes);
    const std::uint64_t header[] = {n_bytes > 0 ? 1u : 0u, n_bytes, 0, block.size()};
    append_base64(xml, header, (n_bytes > 0 ? 4 : 3) * sizeof(std::uint64_t));
    if (n_bytes > 0)
      append_base64(xml, block.data(), block.size());
  }



  std::vector<unsigned char> zlib_block(const void *data, const std::size_t n_bytes)
  {
    uLongf                     size = compressBound(n_bytes);
    std::vector<unsigned char> result(size);
    if (compress2(
          result.data(), &size, static_cast<const unsigned char *>(data), n_bytes, Z_BEST_SPEED) !=
        Z_OK)
      throw std::runtime_error("zlib has no memory to compress a picture");
    result.resize(size);
    return result;
  }
} // namespace hybrid::output
