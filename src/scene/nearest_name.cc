// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace hybrid::scene
{
  namespace
  {
    char lower(const char c)
    {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }

    /// Levenshtein distance, ignoring case.
    std::size_t edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), std::size_t(0));
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const std::size_t replace = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
              diagonal                  = row[j + 1];
              row[j + 1]                = std::min({replace, row[j] + 1, row[j + 1] + 1});
            }
        }
      return row.back();
    }
  } // namespace

  std::string nearest_name(const std::string &name, const std::vector<std::string> &candidates)
  {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string &candidate : candidates)
      {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < best_distance && distance < std::max(name.size(), candidate.size()))
          {
            best          = candidate;
            best_distance = distance;
          }
      }
    return best;
  }

  std::string suggestion(const std::string &name, const std::vector<std::string> &candidates)
  {
    const std::string nearest = nearest_name(name, candidates);
    return nearest.empty() ? "" : " (did you mean '" + nearest + "'?)";
  }
} // namespace hybrid::scene
