// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/input_error.h>
#include <hybrid/scene/parameters/parameter_lines.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace hybrid::scene
{
  /// What a parameter's text must look like; deal.II's Patterns say the same once more.
  struct ParameterPattern
  {
    enum class Kind
    {
      text,
      file, ///< a path that resolves against the file naming it and must exist unless empty
      number,
      integer,
      toggle,
      choice
    };

    Kind        kind = Kind::text;
    std::string allowed; ///< completes "must be ...", e.g. "a number > 0 [s]"
    std::string options; ///< "a|b|c" of a choice
  };

  /// One declared parameter.
  struct ParameterDeclaration
  {
    std::string      name;
    std::string      default_value;
    ParameterPattern pattern;
    std::string      help;

    /// Stores the value in its member. @throws InputError (without file and line) saying what is
    /// allowed.
    std::function<void(const std::string &)> assign;
  };

  /**
   * All parameters of a scene: what is declared, what the user set and where.
   *
   * Use: declare everything (through ParameterSection), set() each line of the file,
   * assign() the members, then ask error() for located messages about contradictions.
   * Values, defaults, patterns and printing are those of a deal.II ParameterHandler, which no
   * other file sees.
   */
  class ParameterTable
  {
  public:
    /// @param file named in errors about parameters that are nowhere set.
    explicit ParameterTable(std::string file);
    ~ParameterTable();

    ParameterTable(const ParameterTable &)            = delete;
    ParameterTable &operator=(const ParameterTable &) = delete;

    void declare(const std::vector<std::string> &section, const ParameterDeclaration &declaration);

    /**
     * Take the value of one line; a later override replaces it, and so does a later line of a file
     * that includes the one with the first.
     * @throws InputError for an unknown section or parameter, a duplicate, and a value that is not
     * allowed.
     */
    void set(const ParameterLine &line);

    /// Store every value, set or default, in its member, in the order of declaration.
    void assign();

    /// Whether the user set the parameter "Section/Name".
    bool is_set(const std::string &path) const;

    /// An error "file:line: Section/Name = value: sentence" at the place where the user set it.
    InputError error(const std::string &path, const std::string &sentence) const;

    /// Write a parameter file with every value, and as comments default, unit, range and help.
    void print(std::ostream &out) const;

  private:
    struct Entry;
    struct Implementation;
    std::unique_ptr<Implementation> implementation;

    void refuse_unknown(const ParameterLine &line) const;

    /// Paths of the files that are named; of a parameter that is set several times, of the last.
    void find_files();
  };
} // namespace hybrid::scene
