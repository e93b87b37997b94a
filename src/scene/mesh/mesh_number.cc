// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/mesh/mesh_number.h>
#include <hybrid/scene/text_table.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::scene
{
  namespace
  {
    /// The number after "key": in the JSON text of a ONELAB parameter, or @p otherwise.
    double json_number(const std::string &json, const std::string &key, const double otherwise)
    {
      const auto position = json.find("\"" + key + "\":");
      double     value    = otherwise;
      if (position != std::string::npos)
        {
          const auto begin = json.find_first_not_of(" ", position + key.size() + 3);
          const auto end   = json.find_first_of(",}\n", begin);
          if (begin == std::string::npos || !parse_number(json.substr(begin, end - begin), value))
            return otherwise;
        }
      return value;
    }


    /// True if gmsh has made up the range.
    bool is_range_of_gmsh(const std::string &json, const double lowest, const double highest)
    {
      const auto begin = json.find("\"values\":[ ");
      double     value = 0.;
      if (begin == std::string::npos ||
          !parse_number(json.substr(begin + 11, json.find(" ]", begin) - begin - 11), value) ||
          value == 0.)
        return false;
      const double factor = value == std::floor(value) ? 5. : 20.;
      const auto   is     = [&](const double bound, const double made_up) {
        const double error = 1e-9 * std::abs(value);
        return std::abs(bound - made_up) <= error || std::abs(bound - std::trunc(made_up)) <= error;
      };
      const double near = value / factor, far = value * factor;
      return is(lowest, std::min(near, far)) && is(highest, std::max(near, far));
    }
  } // namespace



  std::string outside_range(const std::string &json, const double value)
  {
    const double lowest  = json_number(json, "min", -1e300);
    const double highest = json_number(json, "max", 1e300);
    if ((value >= lowest && value <= highest) || is_range_of_gmsh(json, lowest, highest))
      return "";
    std::ostringstream sentence;
    sentence << value << "; it must be at least " << lowest;
    if (highest < 1e100)
      sentence << " and at most " << highest;
    return sentence.str();
  }
} // namespace hybrid::scene
