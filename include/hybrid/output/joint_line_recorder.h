// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/joint_line.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/output/history_file.h>
#include <hybrid/output/summary.h>
#include <hybrid/restart/archive_forward.h>

#include <vector>

namespace hybrid::output
{
  /**
   * The group `joint_lines` of run.h5: how far the two sides of each line joint_<suffix> of the
   * mass have slid along each other and parted since the state at rest, edge by edge.
   *
   * An edge belongs to two blocks. The middles of its two copies were one place; the way between
   * them is seen along the edge of the first block as it lies now. Slip is that of the upper side
   * along +x (of an upright edge that of the left side upwards), opening is positive. Springs make
   * a part of both that is no slip.
   */
  class JointLineRecorder
  {
  public:
    /// @param blocks may be nullptr.  @param threshold what slides farther has slipped [m].
    JointLineRecorder(const dda::Model *blocks, double threshold);

    void add_series(HistoryFile &file);

    /// Slip and opening count from @p state.
    void set_reference(const dda::DdaState &state);

    /// Of all edges at @p time [s].
    void record(const dda::DdaState &state, double time, HistoryFile &file) const;

    /// What is left at the end of the run.
    void summarize(const dda::DdaState &state, Summary &summary) const;

    /// The state at rest, for the checkpoint.
    void serialize(restart::Archive &archive);

  private:
    /// Slip and opening of each edge of a line [m].
    struct Ways
    {
      std::vector<double> slip, opening;
    };

    struct Line
    {
      const dda::JointLine *edges;
      Ways                  at_rest;
      int                   slip_series = -1, opening_series = -1;
    };

    const dda::Model *model;
    const double      threshold;
    std::vector<Line> lines;
    int               time_series = -1;

    /// Since the blocks were drawn.
    static Ways ways(const dda::Geometry &g, const dda::JointLine &line);

    /// Since the state at rest.
    static Ways since_rest(const dda::DdaState &state, const Line &line);

    /// Middle of an edge, as drawn [m].
    Vec2 place(const dda::JointLine::Edge &edge) const;
  };
} // namespace hybrid::output
