// SPDX-License-Identifier: GPL-3.0-or-later
// Follows "Adding a parameter" of doc/developer_guide.md: a member and a statement.
#include <hybrid/scene/parameters/parameter_section.h>

#include <gtest/gtest.h>

#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    struct PierParameters
    {
      double depth = 4.; ///< [m]
    };



    void declare(ParameterTable &table, PierParameters &pier)
    {
      ParameterSection section(table, {"Pier"});
      section.number("Depth", pier.depth, "m", ParameterRange::above(0.), "Depth of the pier.");
    }



    /// Depth as a user sets it.
    double depth_of(const std::string &line)
    {
      PierParameters pier;
      ParameterTable table("test");
      declare(table, pier);
      if (!line.empty())
        table.set(parse_override(line));
      table.assign();
      return pier.depth;
    }



    std::string refusal_of(const std::string &line)
    {
      try
        {
          depth_of(line);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }
  } // namespace



  TEST(ParameterSection, ANewParameterIsAMemberAndAStatement)
  {
    EXPECT_EQ(depth_of(""), 4.);
    EXPECT_EQ(depth_of("Pier/Depth=2.5"), 2.5);
    for (const char *line : {"Pier/Depth=-1", "Pier/Depth=deep"})
      {
        const std::string text = refusal_of(line);
        EXPECT_NE(text.find("Pier/Depth"), std::string::npos) << text;
        EXPECT_NE(text.find("a number > 0 [m]"), std::string::npos) << text;
      }
    EXPECT_NE(refusal_of("Pier/Dept=1").find("Depth"), std::string::npos) << "suggested";
  }



  TEST(ParameterSection, ItsUnitRangeAndHelpArePrinted)
  {
    PierParameters pier;
    ParameterTable table("test");
    declare(table, pier);
    std::ostringstream text;
    table.print(text);
    for (const char *part : {"subsection Pier", "Depth", "4", "> 0 [m]", "Depth of the pier."})
      EXPECT_NE(text.str().find(part), std::string::npos) << part << " in\n" << text.str();
  }
} // namespace hybrid::scene
