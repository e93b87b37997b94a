// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/option_registry.h>
#include <hybrid/scene/parameters/parameter_range.h>
#include <hybrid/scene/parameters/parameter_table.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace hybrid::scene
{
  /**
   * Declares the parameters of one section: name, member (whose present value is the default),
   * unit, range and help in one statement each.
   *
   * @code
   *   section.number("Time step", p.time_step, "s", ParameterRange::above(0.), "Size dt of a
   * step.");
   * @endcode
   * Table, section and members must outlive ParameterTable::assign().
   */
  class ParameterSection
  {
  public:
    /// @param path nested sections from outside to inside; empty: top level.
    ParameterSection(ParameterTable &parameter_table, std::vector<std::string> path)
      : table(parameter_table)
      , section(std::move(path))
    {}

    void number(const std::string    &name,
                double               &member,
                const std::string    &unit,
                const ParameterRange &range,
                const std::string    &help);

    /// A number, or @p word, which stands for the member's present value.
    void number_or(const std::string                      &name,
                   const std::pair<std::string, double &> &word_and_member,
                   const std::string                      &unit,
                   const ParameterRange                   &range,
                   const std::string                      &help);

    /// A unit that may stand behind a number, and its size in the member's unit.
    using Unit = std::pair<std::string, double>;

    /// As number_or(), with one of @p units behind the number if the user likes; without one it is
    /// in the first. @p has_unit tells whether there was one.
    void quantity_or(const std::string                      &name,
                     const std::pair<std::string, double &> &word_and_member,
                     bool                                   &has_unit,
                     const std::vector<Unit>                &units,
                     const ParameterRange                   &range,
                     const std::string                      &help);

    void integer(const std::string         &name,
                 int                       &member,
                 const std::pair<int, int> &range,
                 const std::string         &help);

    void toggle(const std::string &name, bool &member, const std::string &help);

    void text(const std::string &name,
              std::string       &member,
              const std::string &allowed,
              const std::string &help);

    /// A path that resolves against the file that names it; empty: none.
    void file(const std::string &name,
              std::string       &member,
              const std::string &allowed,
              const std::string &help);

    /// "a, b, c".
    void names(const std::string &name, std::vector<std::string> &member, const std::string &help);

    /// One of a few words; @p pick is called with the chosen one.
    void choice(const std::string                       &name,
                const std::vector<std::string>          &options,
                const std::string                       &default_option,
                std::function<void(const std::string &)> pick,
                const std::string                       &help);

    /// One of a few words, each standing for a value of the member.
    template <typename Value>
    void choice(const std::string                                &name,
                Value                                            &member,
                const std::vector<std::pair<std::string, Value>> &options,
                const std::string                                &help);

    /// One of the options of a registry, each of which has a name.
    template <typename Option>
    void option(const std::string         &name,
                Option                    &member,
                const std::vector<Option> &registry,
                const std::string         &help);

    /// Anything else: @p assign stores the text or throws InputError with the reason.
    void value(const std::string                       &name,
               const std::string                       &allowed,
               std::function<void(const std::string &)> assign,
               const std::string                       &help);

  private:
    ParameterTable          &table;
    std::vector<std::string> section;
  };


  template <typename Value>
  void ParameterSection::choice(const std::string                                &name,
                                Value                                            &member,
                                const std::vector<std::pair<std::string, Value>> &options,
                                const std::string                                &help)
  {
    std::vector<std::string> words;
    std::string              default_word;
    for (const auto &option : options)
      {
        words.push_back(option.first);
        if (option.second == member)
          default_word = option.first;
      }
    const auto pick = [&member, options](const std::string &word) {
      member = std::find_if(options.begin(), options.end(), [&](const auto &option) {
                 return option.first == word;
               })->second;
    };
    choice(name, words, default_word, pick, help);
  }



  template <typename Option>
  void ParameterSection::option(const std::string         &name,
                                Option                    &member,
                                const std::vector<Option> &registry,
                                const std::string         &help)
  {
    std::vector<std::string> names;
    for (const Option &each : registry)
      names.push_back(each.name);
    const auto pick = [&member, registry](const std::string &word) {
      member = *find_option(word, registry);
    };
    choice(name, names, member.name, pick, help);
  }
} // namespace hybrid::scene
