// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/archive.h>
#include <hybrid/scene/input_error.h>

#include <cstring>

namespace hybrid::restart
{
  Archive::Archive(const Direction which)
    : direction(which)
  {}



  Archive Archive::writer(const std::size_t expected_size)
  {
    Archive archive(Direction::write);
    archive.bytes.reserve(expected_size);
    return archive;
  }



  Archive Archive::counter()
  {
    return Archive(Direction::count);
  }



  Archive Archive::reader(std::string content)
  {
    Archive archive(Direction::read);
    archive.bytes = std::move(content);
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
        bytes.append(static_cast<const char *>(memory), n);
        return;
      }
    if (direction == Direction::count)
      {
        position += n;
        return;
      }
    if (n > bytes.size() - position)
      throw InputError("the checkpoint ends too early");
    std::memcpy(memory, bytes.data() + position, n);
    position += n;
  }



  std::size_t Archive::move_length(const std::size_t length, const std::size_t element_size)
  {
    std::uint64_t n = length;
    move(&n, sizeof(n));
    if (is_reading() && n > (bytes.size() - position) / element_size)
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



  std::uint64_t checksum(const std::string &bytes)
  {
    std::uint64_t hash = 14695981039346656037u;
    for (const char byte : bytes)
      hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    return hash;
  }
} // namespace hybrid::restart
