// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/restart/durable_file.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace hybrid::restart
{
  namespace
  {
    /// First bytes of every checkpoint. The number tells the byte order.
    constexpr std::array<char, 8> magic      = {'h', 'y', 'b', 'r', 'i', 'd', 'c', 'p'};
    constexpr std::uint32_t       byte_order = 0x01020304;

    /// Reading the header needs as many bytes.
    constexpr std::size_t header_size = sizeof(magic) + 2 * sizeof(std::uint32_t);
  } // namespace



  void write_checkpoint(const std::string &file_name, const CheckpointContent &content)
  {
    Archive archive = Archive::writer();
    archive.put(magic);
    archive.put(byte_order);
    archive.put(checkpoint_version);
    archive.put(content.layout);
    archive.put(checksum(content.state));
    archive.put(static_cast<std::uint64_t>(content.state.size())); // as in front of any text
    replace_file(file_name, {archive.content(), content.state}, true);
  }



  CheckpointContent read_checkpoint(const std::string &file_name)
  {
    std::ifstream file(file_name, std::ios::binary);
    if (!file)
      throw InputError("there is no checkpoint '" + file_name + "'");
    std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (bytes.size() < header_size || !std::equal(magic.begin(), magic.end(), bytes.begin()))
      throw InputError("'" + file_name + "' is no checkpoint of hybrid");

    Archive             archive = Archive::reader(std::move(bytes));
    std::array<char, 8> first;
    std::uint32_t       order = 0, version = 0;
    archive(first, order, version);
    if (order != byte_order)
      throw InputError("the checkpoint '" + file_name +
                       "' was written on a machine with another byte order");
    if (version != checkpoint_version)
      throw InputError("the checkpoint '" + file_name + "' has version " + std::to_string(version) +
                       ", this program reads version " + std::to_string(checkpoint_version) +
                       ": resume with the program that wrote it");
    CheckpointContent content;
    std::uint64_t     expected = 0;
    try
      {
        archive(content.layout, expected, content.state);
      }
    catch (const InputError &)
      {
        expected = ~checksum(content.state);
      }
    if (expected != checksum(content.state) || !archive.at_end())
      throw InputError("the checkpoint '" + file_name + "' is damaged");
    return content;
  }
} // namespace hybrid::restart
