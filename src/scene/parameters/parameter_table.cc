// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/nearest_name.h>
#include <hybrid/scene/parameters/parameter_table.h>
#include <hybrid/scene/path_hint.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>

namespace hybrid::scene
{
  namespace Patterns = dealii::Patterns;

  struct ParameterTable::Entry
  {
    std::vector<std::string> section;
    ParameterDeclaration     declaration;
    bool                     is_set = false;
    ParameterLine            line; ///< where it was set
  };

  struct ParameterTable::Implementation
  {
    std::string                        file;
    dealii::ParameterHandler           handler;
    std::vector<Entry>                 entries; ///< in the order of declaration
    std::map<std::string, std::size_t> index;   ///< "Section/Name" -> entry

    void enter(const std::vector<std::string> &section)
    {
      for (const std::string &name : section)
        handler.enter_subsection(name);
    }

    void leave(const std::vector<std::string> &section)
    {
      for (std::size_t i = 0; i < section.size(); ++i)
        handler.leave_subsection();
    }

    std::string value(const Entry &entry)
    {
      enter(entry.section);
      const std::string text = handler.get(entry.declaration.name);
      leave(entry.section);
      return text;
    }
  };

  namespace
  {
    std::unique_ptr<Patterns::PatternBase> deal_ii_pattern(const ParameterPattern &pattern)
    {
      switch (pattern.kind)
        {
          case ParameterPattern::Kind::number:
            return std::make_unique<Patterns::Double>();
          case ParameterPattern::Kind::integer:
            return std::make_unique<Patterns::Integer>();
          case ParameterPattern::Kind::toggle:
            return std::make_unique<Patterns::Bool>();
          case ParameterPattern::Kind::choice:
            return std::make_unique<Patterns::Selection>(pattern.options);
          case ParameterPattern::Kind::text:
          case ParameterPattern::Kind::file:
            break;
        }
      return std::make_unique<Patterns::Anything>();
    }

    /// Absolute path of a file that @p line names.
    std::string resolve_file(const ParameterLine &line)
    {
      namespace fs = std::filesystem;
      if (line.value.empty())
        return "";
      const fs::path  base = line.is_override ? fs::path() : fs::path(line.file).parent_path();
      const fs::path  path = fs::absolute(base / line.value).lexically_normal();
      std::error_code unknown;
      if (!fs::is_regular_file(path, unknown))
        throw line.error(line.path() + " = '" + line.value + "': there is no file '" +
                         path.string() + "'" + file_hint(line.value, path.string()));
      return path.string();
    }

    bool starts_with(const std::vector<std::string> &all, const std::vector<std::string> &first)
    {
      return first.size() <= all.size() && std::equal(first.begin(), first.end(), all.begin());
    }
  } // namespace

  ParameterTable::ParameterTable(std::string file)
    : implementation(std::make_unique<Implementation>())
  {
    implementation->file = std::move(file);
  }

  ParameterTable::~ParameterTable() = default;

  void ParameterTable::declare(const std::vector<std::string> &section,
                               const ParameterDeclaration     &declaration)
  {
    Implementation &table = *implementation;
    table.enter(section);
    table.handler.declare_entry(declaration.name,
                                declaration.default_value,
                                *deal_ii_pattern(declaration.pattern),
                                declaration.help + " Allowed: " + declaration.pattern.allowed +
                                  ".");
    table.leave(section);
    ParameterLine line;
    line.section = section;
    line.key     = declaration.name;
    table.index.emplace(line.path(), table.entries.size());
    table.entries.push_back({section, declaration, false, line});
  }

  void ParameterTable::refuse_unknown(const ParameterLine &line) const
  {
    std::vector<std::string> known = line.section; // the part of the section's path that exists
    std::vector<std::string> names;
    std::string              elsewhere;
    for (;;)
      {
        const bool is_parameter = known == line.section;
        for (const Entry &entry : implementation->entries)
          if (is_parameter && entry.section == known)
            names.push_back(entry.declaration.name);
          else if (!is_parameter && starts_with(entry.section, known) &&
                   entry.section.size() > known.size())
            names.push_back(entry.section[known.size()]);
        if (!names.empty() || known.empty())
          break;
        known.pop_back();
      }

    for (const Entry &entry : implementation->entries)
      if (entry.declaration.name == line.key && elsewhere.empty())
        elsewhere = entry.line.path();

    if (known != line.section)
      {
        // Without any name there is no section of a material.
        const bool is_material =
          line.section.front() == "Materials" && line.section.size() > 1 && known.size() < 2;
        const std::string &name = line.section[is_material ? 1 : known.size()];
        const std::string  hint = is_material && known.empty() ? "" : suggestion(name, names);
        throw line.error("unknown section '" + join_path(line.section) + "'" + hint +
                         (is_material ? ": Materials/Names does not list '" + name + "'" : ""));
      }
    if (line.path() == "Model/Continuum") // of earlier versions
      throw line.error(
        "unknown parameter 'Model/Continuum': it is Model/Bedrock now, continuum for "
        "elastic and rigid for none");
    const std::string hint = suggestion(line.key, names);
    throw line.error(
      "unknown parameter '" + line.path() + "'" +
      (hint.empty() && !elsewhere.empty() ? " (did you mean '" + elsewhere + "'?)" : hint));
  }

  void ParameterTable::set(const ParameterLine &line)
  {
    const auto found = implementation->index.find(line.path());
    if (found == implementation->index.end())
      refuse_unknown(line);

    Entry     &entry      = implementation->entries[found->second];
    const bool is_variant = line.depth < entry.line.depth; // of a file that it includes
    if (entry.is_set && !line.is_override && !is_variant)
      throw line.error(
        "parameter '" + line.path() + "' is set a second time; the first is at " + entry.line.file +
        ":" + std::to_string(entry.line.line) +
        (line.depth > entry.line.depth ? "; include a file before what differs from it" : ""));
    entry.is_set = true;
    entry.line   = line;

    const ParameterPattern &pattern = entry.declaration.pattern;
    if (!deal_ii_pattern(pattern)->match(line.value))
      throw error(line.path(), "must be " + pattern.allowed);
    implementation->enter(line.section);
    implementation->handler.set(line.key, line.value);
    implementation->leave(line.section);
  }

  void ParameterTable::find_files()
  {
    for (const Entry &entry : implementation->entries)
      if (entry.is_set && entry.declaration.pattern.kind == ParameterPattern::Kind::file)
        {
          implementation->enter(entry.section);
          implementation->handler.set(entry.line.key, resolve_file(entry.line));
          implementation->leave(entry.section);
        }
  }

  void ParameterTable::assign()
  {
    find_files();
    for (const Entry &entry : implementation->entries)
      try
        {
          entry.declaration.assign(implementation->value(entry));
        }
      catch (const InputError &reason)
        {
          throw error(entry.line.path(), reason.what());
        }
  }

  bool ParameterTable::is_set(const std::string &path) const
  {
    return implementation->entries[implementation->index.at(path)].is_set;
  }

  InputError ParameterTable::error(const std::string &path, const std::string &sentence) const
  {
    const Entry &entry = implementation->entries[implementation->index.at(path)];
    if (!entry.is_set)
      return {implementation->file,
              0,
              path + " (not set, default '" + entry.declaration.default_value + "'): " + sentence};
    return entry.line.error(path + " = '" + entry.line.value + "': " + sentence);
  }

  void ParameterTable::print(std::ostream &out) const
  {
    implementation->handler.print_parameters(out,
                                             dealii::ParameterHandler::PRM |
                                               dealii::ParameterHandler::KeepDeclarationOrder);
  }
} // namespace hybrid::scene
