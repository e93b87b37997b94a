// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace hybrid::restart
{
  class Archive;

  namespace internal
  {
    template <typename T, typename = void>
    struct HasMember : std::false_type
    {};

    template <typename T>
    struct HasMember<
      T,
      std::void_t<decltype(std::declval<T &>().serialize(std::declval<Archive &>()))>>
      : std::true_type
    {};

    template <typename T>
    struct IsFixedMatrix : std::false_type
    {};

    template <typename Scalar, int rows, int columns, int options, int max_rows, int max_columns>
    struct IsFixedMatrix<Eigen::Matrix<Scalar, rows, columns, options, max_rows, max_columns>>
      : std::bool_constant<(rows > 0 && columns > 0)>
    {};

    /// Written as the bytes that it has in memory.
    template <typename T>
    constexpr bool is_plain =
      std::is_arithmetic_v<T> || std::is_enum_v<T> || IsFixedMatrix<T>::value;
  } // namespace internal


  /**
   * Bytes of a state, written or read by one and the same function.
   *
   * A struct takes part by a free function `void serialize(Archive &, Struct &)` in its namespace,
   * or by a member `void serialize(Archive &)` where members are private. It names every member
   * once:
   *
   *     void serialize(restart::Archive &archive, SlipState &state)
   *     {
   *       auto &[jump, path, failed, condition] = state; // does not compile if one is missing
   *       archive(jump, path, failed, condition);
   *     }
   *
   * A third direction writes nothing but which types follow each other: its text is equal for two
   * builds of the program only if one can read what the other wrote.
   */
  class Archive
  {
  public:
    /// Takes the next bytes of a writer.
    using Sink = std::function<void(std::string_view)>;

    /// Archive that is filled.
    static Archive writer();

    /// Archive whose bytes go to @p sink in portions; flush() hands over the last one.
    static Archive writer(Sink sink);

    /// Archive that is read from @p content.
    static Archive reader(std::string content);

    /// The same; @p content has to outlive it.
    static Archive reader_of(std::string_view content);

    /// Archive that is filled with the types of what it visits.
    static Archive describer();

    /// Write, read or describe @p members one after the other. @throws InputError if there is less
    /// to read than asked for.
    template <typename... Members>
    void operator()(Members &...members)
    {
      (visit(members), ...);
    }

    /// Write what is constant. @pre the archive is no reader
    template <typename T>
    void put(const T &value)
    {
      visit(const_cast<T &>(value));
    }

    bool is_reading() const
    {
      return direction == Direction::read;
    }

    /// All bytes, or the description.
    const std::string &content() const
    {
      return bytes;
    }

    /// Hand what is left to the sink. @pre the archive has one
    void flush();

    /// Everything has been read.
    bool at_end() const
    {
      return position == source().size();
    }

    /// Pass over @p n bytes. @return where they begin in what is read. @throws InputError if there
    /// are fewer.
    std::size_t skip(std::size_t n);

    /// Where @p vector would be written or read, @p in_its_place is called.
    void stand_in(const std::vector<double> &vector, std::function<void(Archive &)> in_its_place)
    {
      stand_ins[&vector] = std::move(in_its_place);
    }

  private:
    enum class Direction
    {
      write,
      read,
      describe
    };

    explicit Archive(Direction which);

    Direction   direction;
    std::string bytes;
    std::size_t position = 0; ///< of the next byte to read
    Sink        sink;         ///< none: all bytes are kept

    std::string_view                                       foreign; ///< what is read, if not bytes
    std::map<const void *, std::function<void(Archive &)>> stand_ins;

    std::string_view source() const
    {
      return foreign.data() != nullptr ? foreign : std::string_view(bytes);
    }

    /// @p n bytes to or from memory.
    void move(void *memory, std::size_t n);

    /// A length of @p element_size bytes each, checked against what is left. @return the new one.
    std::size_t move_length(std::size_t length, std::size_t element_size);

    void describe(const std::string &what)
    {
      bytes += what;
    }

    bool is_describing() const
    {
      return direction == Direction::describe;
    }

    template <typename T>
    void visit(T &value)
    {
      if constexpr (internal::is_plain<T>)
        {
          if (is_describing())
            describe((std::is_floating_point_v<T> ? "f"
                      : std::is_enum_v<T>         ? "e"
                                                  : "b") +
                     std::to_string(sizeof(T)));
          else
            move(&value, sizeof(T));
        }
      else
        {
          describe_mark("{");
          if constexpr (internal::HasMember<T>::value)
            value.serialize(*this);
          else
            serialize(*this, value);
          describe_mark("}");
        }
    }

    template <typename T>
    void visit(std::vector<T> &values)
    {
      static_assert(!std::is_same_v<T, bool>, "vector<bool> has no bytes of its own");
      if (is_describing())
        {
          describe("[");
          T element{};
          visit(element);
          describe("]");
          return;
        }
      if (const auto other = stand_ins.find(&values); other != stand_ins.end())
        return other->second(*this);
      values.resize(move_length(values.size(), internal::is_plain<T> ? sizeof(T) : 1));
      if constexpr (internal::is_plain<T>)
        move(values.data(), values.size() * sizeof(T));
      else
        for (T &value : values)
          visit(value);
    }

    template <typename T, std::size_t n>
    void visit(T (&values)[n])
    {
      for (T &value : values)
        visit(value);
    }

    template <typename T, std::size_t n>
    void visit(std::array<T, n> &values)
    {
      for (T &value : values)
        visit(value);
    }

    template <typename T>
    void visit(std::map<std::string, T> &values)
    {
      std::vector<std::string> keys;
      for (const auto &entry : values)
        keys.push_back(entry.first);
      visit(keys);
      if (is_describing())
        {
          T value{};
          visit(value);
          return;
        }
      for (const std::string &key : keys)
        visit(values[key]);
    }

    void visit(std::string &text);

    void visit(Eigen::VectorXd &vector);

    void describe_mark(const char *mark)
    {
      if (is_describing())
        describe(mark);
    }
  };

  /// 64-bit checksum (Fowler, Noll, Vo: FNV-1a) of bytes. @param before checksum of those in front
  std::uint64_t checksum(std::string_view bytes, std::uint64_t before = 14695981039346656037u);
} // namespace hybrid::restart
