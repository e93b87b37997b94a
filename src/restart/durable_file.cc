// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/restart/durable_file.h>
#include <hybrid/restart/write_error.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace hybrid::restart
{
  namespace
  {
    WriteError failure(const std::string &path, const int number)
    {
      return WriteError("cannot write '" + path + "': " + std::strerror(number));
    }



    /// An open file or directory.
    class Descriptor
    {
    public:
      explicit Descriptor(const int number)
        : descriptor(number)
      {}

      ~Descriptor()
      {
        if (descriptor >= 0)
          close(descriptor);
      }

      Descriptor(const Descriptor &)            = delete;
      Descriptor &operator=(const Descriptor &) = delete;

      bool is_open() const
      {
        return descriptor >= 0;
      }

      bool write_all(std::string_view content) const
      {
        while (!content.empty())
          {
            const ssize_t n = write(descriptor, content.data(), content.size());
            if (n < 0 && errno != EINTR)
              return false;
            content.remove_prefix(n > 0 ? static_cast<std::size_t>(n) : 0);
          }
        return true;
      }

      bool synchronize() const
      {
        return fsync(descriptor) == 0 || errno == EINVAL; // some file systems cannot
      }

    private:
      const int descriptor;
    };
  } // namespace



  std::string temporary_name(const std::string &file_name)
  {
    return file_name + ".tmp";
  }



  void
  replace_file(const std::string &file_name,
               const std::function<void(const std::function<void(std::string_view)> &file)> &write,
               const bool durable)
  {
    const std::string temporary = temporary_name(file_name);
    const auto        check     = [&](const bool succeeded) {
      if (!succeeded)
        throw failure(file_name, errno);
    };
    try
      {
        const Descriptor file(
          open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
        check(file.is_open());
        write([&](const std::string_view bytes) { check(file.write_all(bytes)); });
        check(!durable || file.synchronize());
      }
    catch (...)
      {
        std::remove(temporary.c_str());
        throw;
      }
    if (const int error = put_in_place(file_name, durable); error != 0)
      throw failure(file_name, error);
  }



  int put_in_place(const std::string &file_name, const bool durable)
  {
    const std::string temporary = temporary_name(file_name);
    if (std::rename(temporary.c_str(), file_name.c_str()) != 0)
      {
        const int error = errno;
        std::remove(temporary.c_str());
        return error;
      }
    if (!durable)
      return 0;
    const std::string directory = std::filesystem::path(file_name).parent_path().string();
    const Descriptor  folder(open(directory.empty() ? "." : directory.c_str(), O_RDONLY));
    return folder.is_open() && folder.synchronize() ? 0 : errno;
  }



  void
  replace_file(const std::string &file_name, const std::string_view content, const bool durable)
  {
    replace_file(
      file_name, [&](const auto &file) { file(content); }, durable);
  }
} // namespace hybrid::restart
