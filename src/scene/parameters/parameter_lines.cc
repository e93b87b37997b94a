// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_lines.h>
#include <hybrid/scene/parameters/parameter_values.h>
#include <hybrid/scene/path_hint.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace hybrid::scene
{
  namespace
  {
    /// Line number of an opened subsection, for the message about a missing `end`.
    struct OpenSection
    {
      std::string name;
      int         line;
    };

    class Scanner
    {
    public:
      std::vector<ParameterLine> lines;

      void scan(const std::string &file);

    private:
      std::vector<std::string> files;   ///< being read, outermost first
      std::vector<std::string> section; ///< open subsections of all files

      void scan_statement(const std::string        &statement,
                          const std::string        &file,
                          int                       line,
                          std::vector<OpenSection> &open);

      void add_setting(const std::string &rest, const std::string &file, int line);

      void include(const std::string &name, const std::string &file, int line);
    };

    void Scanner::scan(const std::string &file)
    {
      std::ifstream   in(file);
      std::error_code unknown; // a name that is too long, for instance: it cannot be read either
      if (std::filesystem::is_directory(file, unknown))
        throw InputError("'" + file + "' is a directory, not a parameter file");
      if (!in)
        {
          const std::string reason = std::strerror(errno);
          throw InputError("parameter file '" + file + "' cannot be read: " + reason +
                           file_hint(file, file));
        }

      files.push_back(std::filesystem::weakly_canonical(file).string());
      std::vector<OpenSection> open;
      std::string              statement, text;
      int                      line = 0, first_line = 0;
      bool                     continued = false;
      while (std::getline(in, text))
        {
          ++line;
          check_text(text, file, line);
          text = trim(text.substr(0, text.find('#')));
          if (!continued)
            first_line = line;
          continued = !text.empty() && text.back() == '\\';
          if (continued)
            text.pop_back();
          statement += text;
          if (!continued)
            {
              scan_statement(statement, file, first_line, open);
              statement.clear();
            }
        }
      if (continued)
        throw InputError(file,
                         first_line,
                         "the last line ends with a backslash but nothing follows");
      if (!open.empty())
        throw InputError(file,
                         open.back().line,
                         "subsection '" + open.back().name +
                           "' is not closed: 'end' is missing before the end of the file");
      files.pop_back();
    }

    void Scanner::scan_statement(const std::string        &statement,
                                 const std::string        &file,
                                 const int                 line,
                                 std::vector<OpenSection> &open)
    {
      const std::string text = trim(statement);
      if (text.empty())
        return;
      const std::size_t space = text.find_first_of(" \t");
      const std::string word  = text.substr(0, space);
      const std::string rest  = space == std::string::npos ? "" : trim(text.substr(space));
      if (word == "set")
        add_setting(rest, file, line);
      else if (word == "subsection")
        {
          if (rest.empty())
            throw InputError(file, line, "'subsection' must be followed by a name");
          open.push_back({rest, line});
          section.push_back(rest);
        }
      else if (text == "end")
        {
          if (open.empty())
            throw InputError(file, line, "'end' closes no subsection of this file");
          open.pop_back();
          section.pop_back();
        }
      else if (word == "include")
        include(rest, file, line);
      else
        throw InputError(
          file,
          line,
          "'" + text +
            "' is not understood: a line must be 'subsection NAME', 'set NAME = VALUE', "
            "'end', 'include FILE' or a # comment");
    }

    void Scanner::add_setting(const std::string &rest, const std::string &file, const int line)
    {
      const std::size_t equals = rest.find('=');
      const std::string key    = trim(rest.substr(0, equals));
      if (equals == std::string::npos || key.empty())
        throw InputError(file, line, "'set " + rest + "' must have the form 'set NAME = VALUE'");
      lines.push_back({file,
                       line,
                       section,
                       key,
                       trim(rest.substr(equals + 1)),
                       false,
                       static_cast<int>(files.size()) - 1});
    }

    void Scanner::include(const std::string &name, const std::string &file, const int line)
    {
      namespace fs = std::filesystem;
      if (name.empty())
        throw InputError(file, line, "'include' must be followed by a file name");
      const std::string path =
        (fs::path(file).parent_path() / name).lexically_normal().string(); // absolute names stay
      std::error_code unknown;
      if (!fs::is_regular_file(path, unknown))
        throw InputError(file,
                         line,
                         "included file '" + path + "' cannot be read" + file_hint(name, path));
      if (std::count(files.begin(), files.end(), fs::weakly_canonical(path).string()) > 0)
        throw InputError(file, line, "included file '" + path + "' includes itself");
      scan(path);
    }
  } // namespace

  std::string join_path(const std::vector<std::string> &section)
  {
    std::string path;
    for (const std::string &name : section)
      path += (path.empty() ? "" : "/") + name;
    return path;
  }

  std::string ParameterLine::path() const
  {
    return section.empty() ? key : join_path(section) + "/" + key;
  }

  InputError ParameterLine::error(const std::string &sentence) const
  {
    return {file, line, sentence};
  }

  std::vector<ParameterLine> scan_parameter_file(const std::string &file)
  {
    Scanner scanner;
    scanner.scan(file);
    return std::move(scanner.lines);
  }

  ParameterLine parse_override(const std::string &option)
  {
    const std::size_t        equals = option.find('=');
    std::vector<std::string> path   = split(option.substr(0, equals), '/');
    if (equals == std::string::npos || std::count(path.begin(), path.end(), "") > 0)
      throw InputError("-s option", 0, "'" + option + "' must have the form Section/Name=value");
    const std::string key = path.back();
    path.pop_back();
    return {"-s option", 0, path, key, trim(option.substr(equals + 1)), true};
  }
} // namespace hybrid::scene
