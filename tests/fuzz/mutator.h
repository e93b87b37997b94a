// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

namespace hybrid::fuzz
{
  /**
   * Changes texts in the ways in which input files go wrong: nonsense values, words swapped, lines
   * deleted, doubled or mixed, files cut off, bytes that are no text. Equal seeds give equal texts.
   */
  class Mutator
  {
  public:
    explicit Mutator(const unsigned long seed)
      : random(seed)
    {}

    /// One to four changes of @p text.
    std::string mutate(std::string text)
    {
      for (std::size_t n = 1 + below(4); n > 0; --n)
        change(text);
      return text;
    }

  private:
    std::mt19937_64 random;

    std::size_t below(const std::size_t n)
    {
      return n == 0 ? 0 : random() % n;
    }

    const std::string &nonsense()
    {
      static const std::vector<std::string> values = {"nan",
                                                      "-nan",
                                                      "inf",
                                                      "-inf",
                                                      "1e308",
                                                      "-1e308",
                                                      "1e-308",
                                                      "1e400",
                                                      "0",
                                                      "-0",
                                                      "-1",
                                                      "",
                                                      "2147483648",
                                                      "-9223372036854775809",
                                                      "1,5",
                                                      "0x10",
                                                      "1e",
                                                      "true",
                                                      "\xff\xfe",
                                                      "%s%n",
                                                      "..",
                                                      "/",
                                                      std::string(3000, '9'),
                                                      std::string("\0", 1)};
      return values[below(values.size())];
    }

    /// Begin and end of a word (digits, letters, signs) or, by chance, of a whole line.
    std::pair<std::size_t, std::size_t> word(const std::string &text)
    {
      const char *const ends  = below(8) == 0 ? "\n" : " \t\n,;:=";
      const std::size_t at    = below(text.size());
      std::size_t       begin = text.find_last_of(ends, at);
      begin                   = begin == std::string::npos ? 0 : begin + 1;
      const std::size_t end   = std::min(text.find_first_of(ends, begin), text.size());
      return {begin, end - begin};
    }

    /// Begin and length of a line with its end.
    std::pair<std::size_t, std::size_t> line(const std::string &text)
    {
      std::size_t begin = text.rfind('\n', below(text.size()));
      begin             = begin == std::string::npos ? 0 : begin + 1;
      const auto end    = text.find('\n', begin);
      return {begin, (end == std::string::npos ? text.size() : end + 1) - begin};
    }

    void change(std::string &text)
    {
      const auto [a, length]      = line(text);
      const auto [w, word_length] = word(text);
      switch (below(10))
        {
          case 0:
            text.erase(a, length);
            break;
          case 1:
            text.insert(a, text.substr(a, length));
            break;
            case 2: {
              const std::string moved = text.substr(a, length);
              text.erase(a, length);
              text.insert(line(text).first, moved);
              break;
            }
          case 3:
            text.resize(below(text.size() + 1));
            break;
          case 4:
            if (!text.empty())
              text[below(text.size())] = static_cast<char>(random());
            break;
          case 5:
            for (std::size_t n = below(40); n > 0; --n)
              text.insert(text.begin() + below(text.size() + 1), static_cast<char>(random()));
            break;
            case 6: {
              const auto [o, other_length] = word(text);
              text.replace(w, word_length, text.substr(o, other_length));
              break;
            }
          default:
            text.replace(w, word_length, nonsense());
        }
    }
  };
} // namespace hybrid::fuzz
