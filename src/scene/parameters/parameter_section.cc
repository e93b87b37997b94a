// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/parameters/parameter_section.h>

namespace hybrid::scene
{
  using Kind = ParameterPattern::Kind;

  namespace
  {
    std::string with_unit(const std::string &unit)
    {
      return unit.empty() ? "" : " [" + unit + "]";
    }

    double number_in_range(const std::string    &text,
                           const ParameterRange &range,
                           const std::string    &allowed)
    {
      const std::optional<double> number = parse_number(text);
      if (!number || !range.contains(*number))
        throw InputError("must be " + allowed);
      return *number;
    }
  } // namespace

  void ParameterSection::number(const std::string    &name,
                                double               &member,
                                const std::string    &unit,
                                const ParameterRange &range,
                                const std::string    &help)
  {
    const std::string allowed = "a number" + range.text() + with_unit(unit);
    table.declare(section,
                  {name,
                   number_text(member),
                   {Kind::number, allowed, ""},
                   help,
                   [=, &member](const std::string &value) {
                     member = number_in_range(value, range, allowed);
                   }});
  }

  void ParameterSection::number_or(const std::string                      &name,
                                   const std::pair<std::string, double &> &word_and_member,
                                   const std::string                      &unit,
                                   const ParameterRange                   &range,
                                   const std::string                      &help)
  {
    const std::string word    = word_and_member.first;
    double           &member  = word_and_member.second;
    const std::string allowed = "'" + word + "' or a number" + range.text() + with_unit(unit);
    table.declare(
      section,
      {name, word, {Kind::text, allowed, ""}, help, [=, &member](const std::string &value) {
         if (value != word)
           member = number_in_range(value, range, allowed);
       }});
  }

  void ParameterSection::quantity_or(const std::string                      &name,
                                     const std::pair<std::string, double &> &word_and_member,
                                     bool                                   &has_unit,
                                     const std::vector<Unit>                &units,
                                     const ParameterRange                   &range,
                                     const std::string                      &help)
  {
    const std::string word   = word_and_member.first;
    double           &member = word_and_member.second;
    std::string       list;
    for (const Unit &unit : units)
      list += (list.empty() ? "" : unit == units.back() ? " or " : ", ") + unit.first;
    const std::string allowed = "'" + word + "' or a number" + range.text() +
                                with_unit(units.front().first) + ", with or without its unit " +
                                list;
    const auto assign = [=, &member, &has_unit](const std::string &value) {
      has_unit = false;
      if (value == word)
        return;
      const std::size_t end  = value.find_first_not_of("+-.0123456789eE");
      const std::string text = value.substr(0, end);
      double            size = 1.;
      if (end != std::string::npos)
        {
          const auto unit = std::find_if(units.begin(), units.end(), [&](const Unit &u) {
            return u.first == trim(value.substr(end));
          });
          if (unit == units.end())
            throw InputError("must be " + allowed);
          has_unit = true;
          size     = unit->second;
        }
      const std::optional<double> number = parse_number(text);
      if (!number || !range.contains(size * *number))
        throw InputError("must be " + allowed);
      member = size * *number;
    };
    table.declare(section, {name, word, {Kind::text, allowed, ""}, help, assign});
  }

  void ParameterSection::integer(const std::string         &name,
                                 int                       &member,
                                 const std::pair<int, int> &range,
                                 const std::string         &help)
  {
    const std::string allowed =
      "an integer from " + std::to_string(range.first) + " to " + std::to_string(range.second);
    table.declare(section,
                  {name,
                   std::to_string(member),
                   {Kind::integer, allowed, ""},
                   help,
                   [=, &member](const std::string &value) {
                     const std::optional<int> number = parse_integer(value);
                     if (!number || *number < range.first || *number > range.second)
                       throw InputError("must be " + allowed);
                     member = *number;
                   }});
  }

  void ParameterSection::toggle(const std::string &name, bool &member, const std::string &help)
  {
    table.declare(section,
                  {name,
                   member ? "true" : "false",
                   {Kind::toggle, "true or false", ""},
                   help,
                   [&member](const std::string &value) {
                     member = value == "true" || value == "yes";
                   }});
  }

  void ParameterSection::text(const std::string &name,
                              std::string       &member,
                              const std::string &allowed,
                              const std::string &help)
  {
    table.declare(
      section, {name, member, {Kind::text, allowed, ""}, help, [&member](const std::string &value) {
                  member = value;
                }});
  }

  void ParameterSection::file(const std::string &name,
                              std::string       &member,
                              const std::string &allowed,
                              const std::string &help)
  {
    table.declare(
      section, {name, member, {Kind::file, allowed, ""}, help, [&member](const std::string &value) {
                  member = value;
                }});
  }

  void ParameterSection::names(const std::string        &name,
                               std::vector<std::string> &member,
                               const std::string        &help)
  {
    value(
      name,
      "names separated by commas",
      [&member](const std::string &text) { member = parse_names(text); },
      help);
  }

  void ParameterSection::choice(const std::string                       &name,
                                const std::vector<std::string>          &options,
                                const std::string                       &default_option,
                                std::function<void(const std::string &)> pick,
                                const std::string                       &help)
  {
    std::string joined, shown;
    for (const std::string &option : options)
      {
        joined += (joined.empty() ? "" : "|") + option;
        shown += (shown.empty() ? "" : " | ") + option;
      }
    table.declare(
      section,
      {name, default_option, {Kind::choice, "one of " + shown, joined}, help, std::move(pick)});
  }

  void ParameterSection::value(const std::string                       &name,
                               const std::string                       &allowed,
                               std::function<void(const std::string &)> assign,
                               const std::string                       &help)
  {
    table.declare(section, {name, "", {Kind::text, allowed, ""}, help, std::move(assign)});
  }
} // namespace hybrid::scene
