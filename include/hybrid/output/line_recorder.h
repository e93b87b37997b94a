// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/history_file.h>
#include <hybrid/output/sample_line.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /**
   * The group `lines` of run.h5: displacement and acceleration along lines.
   *
   * Rows are Monitors/Line interval apart. In a row for every step the acceleration is that at the
   * end of the step, as of monitors; in rows that are farther apart the mean since the row before
   * (the change of velocity over the time), which takes 2.6 % off an eighth of the sampling rate
   * and keeps vibrations of single steps out; the outcrop motion is treated alike before ratios.
   */
  class LineRecorder
  {
  public:
    /// Probes are added to @p probes, which must outlive the recorder.
    LineRecorder(const scene::SceneParameters &scene,
                 const scene::SectionMesh     &mesh,
                 Probes                       &probes);

    /// Make the data sets; nothing without lines.
    void add_series(HistoryFile &file);

    /// Velocities count from this state.
    void start(const coupling::CoupledState &state);

    /// After a step of @p dt [s].
    void record(const coupling::CoupledState &state, double dt, HistoryFile &file);

    /// What the rows to come depend on, for the checkpoint.
    void serialize(restart::Archive &archive);

    /// Numbers of the group `lines` per row.
    static double numbers_per_row(const scene::SceneParameters &scene,
                                  const scene::SectionMesh     &mesh);

    /// Time between rows, in whole steps [s].
    static double interval(const scene::SceneParameters &scene);

  private:
    struct Side
    {
      std::vector<int>  probes;
      std::vector<Vec2> velocity; ///< at the last row [m/s]; empty: not needed
      int               displacement = -1, acceleration = -1;
    };

    struct Line
    {
      SampleLine               points;
      std::vector<std::string> names; ///< of the sides
      std::vector<Side>        sides;
    };

    const Probes       &probes;
    const bool          is_every_step;
    const double        spacing; ///< of rows [s]
    std::vector<Line>   lines;
    std::vector<double> displacement, acceleration; ///< a row
    int                 time     = -1;
    double              next_row = 0., last_row = 0.; ///< times [s]

    void record_side(const coupling::CoupledState &state, Side &side, HistoryFile &file);
  };
} // namespace hybrid::output
