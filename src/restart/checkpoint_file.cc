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

    /// In front of the state: magic, byte order, version, layout. Behind it is its checksum.
    constexpr std::size_t header_size =
      sizeof(magic) + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
  } // namespace



  void write_checkpoint(const std::string                    &file_name,
                        const std::uint64_t                   layout,
                        const std::function<void(Archive &)> &write_state)
  {
    const auto write = [&](const Archive::Sink &file) {
      Archive header = Archive::writer(file);
      header.put(magic);
      header.put(byte_order);
      header.put(checkpoint_version);
      header.put(layout);
      header.flush();
      std::uint64_t sum   = checksum({});
      Archive       state = Archive::writer([&](const std::string_view bytes) {
        sum = checksum(bytes, sum);
        file(bytes);
      });
      write_state(state);
      state.flush();
      Archive end = Archive::writer(file);
      end.put(sum);
      end.flush();
    };
    replace_file(file_name, write, true);
  }



  CheckpointContent read_checkpoint(const std::string &file_name)
  {
    std::ifstream file(file_name, std::ios::binary);
    if (!file)
      throw InputError("there is no checkpoint '" + file_name + "'");
    std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (bytes.size() < sizeof(magic) || !std::equal(magic.begin(), magic.end(), bytes.begin()))
      throw InputError("'" + file_name + "' is no checkpoint of hybrid");
    const InputError damaged("the checkpoint '" + file_name + "' is damaged");
    if (bytes.size() < header_size + sizeof(std::uint64_t))
      throw damaged;

    CheckpointContent   content;
    std::array<char, 8> first;
    std::uint32_t       order = 0, version = 0;
    std::uint64_t       expected = 0;
    Archive::reader(bytes.substr(0, header_size))(first, order, version, content.layout);
    if (order != byte_order)
      throw InputError("the checkpoint '" + file_name +
                       "' was written on a machine with another byte order");
    if (version != checkpoint_version)
      throw InputError("the checkpoint '" + file_name + "' has version " + std::to_string(version) +
                       ", this program reads version " + std::to_string(checkpoint_version) +
                       ": resume with the program that wrote it");
    Archive::reader(bytes.substr(bytes.size() - sizeof(expected)))(expected);
    bytes.resize(bytes.size() - sizeof(expected));
    bytes.erase(0, header_size);
    if (expected != checksum(bytes))
      throw damaged;
    content.state = std::move(bytes);
    return content;
  }
} // namespace hybrid::restart
