// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/base64.h>
#include <hybrid/output/shared_vtu.h>

#include <algorithm>
#include <stdexcept>

namespace hybrid::output
{
  SharedVtu::SharedVtu(const std::string &file_name, const MPI_Comm communicator)
    : file(file_name, communicator)
    , comm(communicator)
  {
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &ranks);
  }



  void SharedVtu::add_text(const std::string_view text)
  {
    if (rank == 0)
      file.write(end, text);
    end += text.size();
  }



  void SharedVtu::add_header(const std::vector<Part> &parts)
  {
    std::vector<std::uint64_t> header{0, parts.front().n_bytes, 0};
    for (const Part &part : parts)
      {
        if (part.n_bytes == 0)
          continue;
        if (header[2] != 0 || part.n_bytes > header[1])
          throw std::logic_error("parts of an array of a shared VTU are of different sizes");
        ++header[0];
        header[2] = part.n_bytes < header[1] ? part.n_bytes : 0;
        header.push_back(part.compressed);
      }
    std::string text;
    append_base64(text, header.data(), header.size() * sizeof(header[0]));
    add_text(text);
  }



  void SharedVtu::add_array(const void *data, const std::size_t n_bytes)
  {
    std::vector<unsigned char> block;
    if (n_bytes > 0)
      block = zlib_block(data, n_bytes);
    Part mine{n_bytes, block.size(), {}};
    std::copy_n(block.begin(), std::min(block.size(), sizeof(mine.first)), mine.first);
    std::vector<Part> parts(ranks);
    MPI_Allgather(&mine, sizeof(Part), MPI_BYTE, parts.data(), sizeof(Part), MPI_BYTE, comm);
    add_header(parts);

    // Base64 makes four characters of three bytes, wherever blocks begin and end: a rank writes the
    // groups that begin in its block. A block has eight bytes or more.
    std::uint64_t before = 0, all = 0;
    for (int r = 0; r < ranks; ++r)
      {
        before += r < rank ? parts[r].compressed : 0;
        all += parts[r].compressed;
      }
    const std::uint64_t skipped = (3 - before % 3) % 3, until = before + block.size();
    if (!block.empty() && rank + 1 < ranks && parts[rank + 1].n_bytes > 0)
      block.insert(block.end(), parts[rank + 1].first, parts[rank + 1].first + (3 - until % 3) % 3);
    if (!block.empty())
      {
        std::string text;
        append_base64(text, block.data() + skipped, block.size() - skipped);
        file.write(end + (before + skipped) / 3 * 4, text);
      }
    end += (all + 2) / 3 * 4;
  }



  void SharedVtu::finish()
  {
    file.finish(false);
  }
} // namespace hybrid::output
