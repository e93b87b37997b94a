// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/nearest_name.h>
#include <hybrid/scene/path_hint.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace hybrid::scene
{
  namespace fs = std::filesystem;

  std::string path_hint(const std::string &written)
  {
    const std::string marks = "\"'";
    if (!written.empty() && (marks.find(written.front()) != std::string::npos ||
                             marks.find(written.back()) != std::string::npos))
      {
        const std::size_t first = written.find_first_not_of(marks);
        return "; leave the quotation marks away" +
               (first == std::string::npos
                  ? ""
                  : ": " + written.substr(first, written.find_last_not_of(marks) - first + 1));
      }
    if (written.rfind("~", 0) == 0)
      {
        const char       *home = std::getenv("HOME");
        const std::string rest = written.substr(1);
        return "; '~' is not replaced here, write the whole path" +
               (home != nullptr && (rest.empty() || rest[0] == '/') ? ": " + (home + rest) : "");
      }
    if (written.rfind("$", 0) == 0)
      return "; variables are not replaced here, write the whole path";
    return "";
  }



  std::string file_hint(const std::string &written, const std::string &path)
  {
    const std::string hint = path_hint(written);
    if (!hint.empty())
      return hint;
    std::error_code error;
    if (fs::is_directory(path, error))
      return "; it is a directory";
    std::vector<std::string> names;
    const fs::path           wanted(path);
    for (fs::directory_iterator
           entry(wanted.parent_path().empty() ? "." : wanted.parent_path(), error),
         end;
         !error && entry != end;
         entry.increment(error))
      if (entry->is_regular_file(error))
        names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end()); // directories have no order
    for (const std::string &name : names)
      if (fs::path(name).stem() == wanted.filename())
        return "; did you mean '" + name + "'?";
    const std::string nearest = nearest_name(wanted.filename().string(), names);
    return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
  }
} // namespace hybrid::scene
