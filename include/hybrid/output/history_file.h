// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/restart/archive_forward.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * The histories of a run in one HDF5 file (run.h5; its data sets are described in run_file.md).
   *
   * A series is a chunked, extendible data set of doubles with one row per call of append(): shape
   * (n) for one column, (n, columns) otherwise. append() copies into a buffer that was allocated by
   * add_series(); HDF5 is called once per full buffer and by flush().
   *
   * A process killed at any moment leaves a file that opens with a plain reader and holds
   * everything up to the last flush(): HDF5 keeps its file in memory, and flush() writes a copy
   * under a temporary name and renames it. (Written in place, 2 of 200 files of processes that were
   * killed while they flushed without pause had an unreadable data set.) That takes 1 ms per MB or
   * less; the caller spaces flushes of large files. A full disk leaves the last flush as it was.
   * The bytes depend on values and calls only, not on the time of day.
   *
   * One thread of one process (rank 0) uses the file.
   */
  class HistoryFile
  {
  public:
    enum class Mode
    {
      create, ///< a new file; an existing one is replaced
      resume ///< an existing file; its series go on where they ended, or where truncate() cuts them
    };

    /// Of the numbers in the file.
    enum class Precision
    {
      full,  ///< 8 bytes
      single ///< 4 bytes, 7 digits: histories of many points
    };

    /// @throws InputError if the file cannot be created or opened.
    explicit HistoryFile(const std::string &name, Mode mode = Mode::create);

    HistoryFile(const HistoryFile &)            = delete;
    HistoryFile &operator=(const HistoryFile &) = delete;

    /// Flushes once more, if that is possible.
    ~HistoryFile();

    /**
     * Create a series, or find it again in a resumed file. Missing groups of @p path are made.
     * @param path such as "monitors/S1/velocity"
     * @param unit such as "m/s"; "1" for counts and ratios
     * @param columns values per row, > 0
     * @return the number of the series, for append().
     */
    int add_series(const std::string &path,
                   const std::string &unit,
                   std::size_t        columns,
                   const std::string &description,
                   Precision          precision = Precision::full);

    /// Add one row, @p values[0 ... columns).
    void append(int series, const double *values);

    /// Rows of a series so far, buffered ones included.
    std::size_t rows(int series) const;

    /// Forget the rows from @p rows on (resuming from a checkpoint that is older than the file).
    void truncate(int series, std::size_t rows);

    /// Write a static array, shape (rows) for one column, (rows, columns) otherwise; replaces an
    /// old one.
    void write_table(const std::string &path,
                     const std::string &unit,
                     const double      *values,
                     std::size_t        rows,
                     std::size_t        columns,
                     const std::string &description = "");

    /// Write a static list of whole numbers, shape (n); replaces an old one.
    void write_integers(const std::string      &path,
                        const std::vector<int> &values,
                        const std::string      &description = "");

    /// Make a table that is written later, by others (SharedTables).
    void declare_table(const std::string &path,
                       const std::string &unit,
                       std::size_t        rows,
                       std::size_t        columns,
                       const std::string &description);

    /// Put all that is there, declared tables included, into another file, and end: the file itself
    /// is that of the last flush. @throws WriteError
    void close_into(const std::string &other_file);

    /// Take a table or a whole group out of the file, if it is there.
    void remove(const std::string &path);

    /// Text attribute of a data set or group; @p path "/" is the file. Groups are made if missing.
    void set_attribute(const std::string &path, const std::string &name, const std::string &text);

    /// Numeric attribute of a data set or group, an array of doubles.
    void set_attribute(const std::string         &path,
                       const std::string         &name,
                       const std::vector<double> &values);

    /// All rows of a series.
    std::vector<double> read(int series);

    /// Bring everything to the file: it can be read up to here from now on. @param durable also
    /// after a power failure. @throws WriteError if it cannot be written; the file is that of the
    /// last flush then.
    void flush(bool durable = false);

    /// Number of rows of every series, for the checkpoint. Reading cuts the series of a resumed
    /// file to these rows. @throws InputError if there are fewer.
    void serialize(restart::Archive &archive);

  private:
    struct Series
    {
      std::string         path;
      std::int64_t        dataset  = -1; ///< HDF5 identifier
      std::size_t         columns  = 1;
      std::size_t         capacity = 0; ///< rows that the buffer holds
      std::size_t         written  = 0; ///< rows in the data set
      std::size_t         buffered = 0; ///< rows in the buffer
      std::vector<double> buffer;
    };

    void write_buffer(Series &series);

    /// All that is there to a file. @throws WriteError
    void write_image(const std::string &to, bool durable);

    void close();

    std::int64_t create_series(const Series      &series,
                               const std::string &unit,
                               const std::string &description,
                               Precision          precision);

    /// Open an existing series and set its number of rows. @throws InputError if its shape differs.
    void open_series(Series &series);

    bool exists(const std::string &path) const;

    /// What a static array is made of.
    struct StaticArray
    {
      const std::string &path, &unit, &description;
      std::size_t        rows, columns;
    };

    /// @param in_file, in_memory HDF5 types of the numbers @param values null: written later
    void write_static(const StaticArray &array,
                      std::int64_t       in_file,
                      std::int64_t       in_memory,
                      const void        *values);

    std::string         file_name;
    std::int64_t        file = -1; ///< HDF5 identifier
    std::vector<Series> all_series;
  };
} // namespace hybrid::output
