// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/scene/input_error.h>

#include <cstring>

namespace hybrid::restart
{
  namespace
  {
    /// Bytes that a sink gets at once.
    constexpr std::size_t portion = 1 << 20;
  } // namespace



  Archive::Archive(const Direction which)
    : direction(which)
  {}



  Archive Archive::writer()
  {
    return Archive(Direction::write);
  }



  Archive Archive::writer(Sink sink)
  {
    Archive archive(Direction::write);
    archive.sink = std::move(sink);
    return archive;
  }



  Archive Archive::reader(std::string content)
  {
    Archive archive(Direction::read);
    archive.bytes = std::move(content);
    return archive;
  }



  Archive Archive::reader_of(const std::string_view content)
  {
    Archive archive(Direction::read);
    archive.foreign = content;
    return archive;
  }



  Archive Archive::describer()
  {
    return Archive(Direction::describe);
  }



  void Archive::move(void *memory, const std::size_t n)
  {
    if (n == 0)
      return;
    if (direction == Direction::write)
      {
        const std::string_view content(static_cast<const char *>(memory), n);
        if (sink && bytes.size() + n >= portion)
          {
            flush();
            sink(content);
          }
        else
          bytes += content;
        return;
      }
    std::memcpy(memory, source().data() + skip(n), n);
  }



  std::size_t Archive::skip(const std::size_t n)
  {
    if (n > source().size() - position)
      throw InputError("the checkpoint ends too early");
    position += n;
    return position - n;
  }



  void Archive::flush()
  {
    sink(bytes);
    bytes.clear();
  }



  std::size_t Archive::move_length(const std::size_t length, const std::size_t element_size)
  {
    std::uint64_t n = length;
    move(&n, sizeof(n));
    if (is_reading() && n > (source().size() - position) / element_size)
      throw InputError("the checkpoint ends too early");
    return static_cast<std::size_t>(n);
  }



  void Archive::visit(std::string &text)
  {
    if (is_describing())
      {
        describe("s");
        return;
      }
    text.resize(move_length(text.size(), 1));
    move(text.data(), text.size());
  }



  void Archive::visit(Eigen::VectorXd &vector)
  {
    if (is_describing())
      {
        describe("v");
        return;
      }
    vector.resize(static_cast<Eigen::Index>(
      move_length(static_cast<std::size_t>(vector.size()), sizeof(double))));
    move(vector.data(), static_cast<std::size_t>(vector.size()) * sizeof(double));
  }



  std::uint64_t checksum(const std::string_view bytes, const std::uint64_t before)
  {
    std::uint64_t hash = before;
    for (const char byte : bytes)
      hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    return hash;
  }
} // namespace hybrid::restart
