// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/atomic_file.h>
#include <hybrid/scene/input_error.h>

#include <cstdio>
#include <fstream>

namespace hybrid::output
{
  void write_atomically(const std::string &file_name, const std::string &content)
  {
    const std::string temporary = file_name + ".tmp";
    {
      std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
      file.write(content.data(), static_cast<std::streamsize>(content.size()));
      file.close();
      if (!file)
        {
          std::remove(temporary.c_str());
          throw InputError("cannot write '" + file_name +
                           "': the directory must exist, be writable and have space left.");
        }
    }
    if (std::rename(temporary.c_str(), file_name.c_str()) != 0)
      {
        std::remove(temporary.c_str());
        throw InputError("cannot replace '" + file_name + "' by its new version.");
      }
  }
} // namespace hybrid::output
