// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/restart/checkpoint_file.h>
#include <hybrid/restart/durable_file.h>
#include <hybrid/scene/input_error.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <tuple>
#include <unistd.h>

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



    /// A file in memory, read page by page where it is looked at; null if there is none.
    std::pair<std::shared_ptr<const char>, std::string_view> map_file(const std::string &file_name)
    {
      const int   file = open(file_name.c_str(), O_RDONLY | O_CLOEXEC);
      struct stat about;
      if (file < 0)
        return {};
      const bool        is_known = fstat(file, &about) == 0 && S_ISREG(about.st_mode);
      const std::size_t size     = is_known ? static_cast<std::size_t>(about.st_size) : 0;
      void *const       memory =
        size > 0 ? mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0) : MAP_FAILED;
      close(file);
      if (!is_known || (size > 0 && memory == MAP_FAILED))
        return {};
      if (size == 0)
        return {std::shared_ptr<const char>("", [](const char *) {}), {}};
      const char *const bytes = static_cast<const char *>(memory);
      return {std::shared_ptr<const char>(
                bytes, [size](const char *begin) { munmap(const_cast<char *>(begin), size); }),
              {bytes, size}};
    }
  } // namespace



  void put_checkpoint(const Archive::Sink                  &file,
                      const std::uint64_t                   layout,
                      std::uint64_t                        &sum,
                      const std::function<void(Archive &)> &write_state)
  {
    Archive header = Archive::writer(file);
    header.put(magic);
    header.put(byte_order);
    header.put(checkpoint_version);
    header.put(layout);
    header.flush();
    Archive state = Archive::writer([&](const std::string_view bytes) {
      sum = checksum(bytes, sum);
      file(bytes);
    });
    write_state(state);
    state.flush();
    Archive end = Archive::writer(file);
    end.put(sum);
    end.flush();
  }



  void write_checkpoint(const std::string                    &file_name,
                        const std::uint64_t                   layout,
                        const std::function<void(Archive &)> &write_state)
  {
    const auto write = [&](const Archive::Sink &file) {
      std::uint64_t sum = checksum({});
      put_checkpoint(file, layout, sum, write_state);
    };
    replace_file(file_name, write, true);
  }



  CheckpointContent read_checkpoint(const std::string &file_name, const bool verify)
  {
    CheckpointContent content;
    std::string_view  bytes;
    errno                         = 0;
    std::tie(content.file, bytes) = map_file(file_name);
    if (content.file == nullptr && (errno == 0 || errno == ENOENT))
      throw InputError("there is no checkpoint '" + file_name + "'");
    if (content.file == nullptr)
      throw InputError("cannot read the checkpoint '" + file_name + "': " + std::strerror(errno));
    if (bytes.size() < sizeof(magic) || !std::equal(magic.begin(), magic.end(), bytes.begin()))
      throw InputError("'" + file_name + "' is no checkpoint of hybrid");
    const InputError damaged("the checkpoint '" + file_name + "' is damaged");
    if (bytes.size() < header_size + sizeof(std::uint64_t))
      throw damaged;

    std::array<char, 8> first;
    std::uint32_t       order = 0, version = 0;
    std::uint64_t       expected = 0;
    Archive::reader_of(bytes.substr(0, header_size))(first, order, version, content.layout);
    if (order != byte_order)
      throw InputError("the checkpoint '" + file_name +
                       "' was written on a machine with another byte order");
    if (version != checkpoint_version)
      throw InputError("the checkpoint '" + file_name + "' has version " + std::to_string(version) +
                       ", this program reads version " + std::to_string(checkpoint_version) +
                       ": resume with the program that wrote it");
    content.state = bytes.substr(header_size, bytes.size() - header_size - sizeof(expected));
    Archive::reader_of(bytes.substr(bytes.size() - sizeof(expected)))(expected);
    if (verify && expected != checksum(content.state))
      throw damaged;
    madvise(const_cast<char *>(content.file.get()), bytes.size(), MADV_DONTNEED); // read anew
    return content;
  }
} // namespace hybrid::restart
