// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/continuum.h>
#include <hybrid/coupling/coupled_state.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/output/history_file.h>
#include <hybrid/output/peak_motion.h>

#include <string>
#include <vector>

namespace hybrid::output
{
  /// The group `fields` of run.h5 and peaks.vtu: peaks of the motion at every node of the bedrock
  /// and every block (its centroid), and the largest slip on planes and soles.
  class PeakFields
  {
  public:
    /// What the scene does not have is nullptr. @param corner of the accelerations' low-pass [Hz]
    PeakFields(const dda::Model *blocks, const continuum::Continuum *bedrock, double corner);

    /// The nodes' are another's (SharedPeaks), who writes them, too.
    void leave_nodes()
    {
      continuum  = nullptr;
      left_nodes = true;
    }

    bool has_left_nodes() const
    {
      return left_nodes;
    }

    /// What a checkpoint has of the nodes.
    PeakMotion &nodes_of_bedrock()
    {
      return nodes;
    }

    std::vector<double> &slip_of_nodes()
    {
      return node_slip;
    }

    static constexpr const char *nodes_group = "fields/nodes/";

    /// Places for the tables of nodes, which another writes: position, peak_acceleration,
    /// peak_velocity, peak_displacement, peak_slip, cells.
    static void declare_nodes(HistoryFile &file, std::size_t n_nodes, std::size_t n_cells);

    /// Motions count from this state.
    void start(const coupling::CoupledState &state);

    /// After a step of @p dt [s]. @param base displacement of the base monitor [m]
    void record(const coupling::CoupledState &state, double dt, const Vec2 &base);

    /// Tables and picture, at the end. @param block_slip largest magnitude at each block's soles
    /// [m]
    void write(const std::vector<double> &block_slip,
               HistoryFile               &file,
               const std::string         &picture) const;

    /// Everything so far, for the checkpoint.
    void serialize(restart::Archive &archive);

    /// Of the fields [B]. @param points nodes and blocks
    static double memory(const std::size_t points)
    {
      constexpr double numbers = 6. + 3.; // of PeakMotion, of the tables
      return 2. * numbers * sizeof(double) * static_cast<double>(points);
    }

  private:
    const dda::Model                         *model;
    const continuum::Continuum               *continuum;
    bool                                      left_nodes = false;
    PeakMotion                                nodes, blocks;
    std::vector<continuum::Continuum::Facing> facing;    ///< nodes on the two sides of planes
    std::vector<double>                       node_slip; ///< largest magnitudes [m]
    std::vector<Vec2>                         centroids; ///< at the start [m]
    std::vector<double>                       displacement, velocity; ///< of blocks, work

    void gather_blocks(const dda::DdaState &state);

    void write_part(HistoryFile               &file,
                    const std::string         &path,
                    const PeakMotion          &peaks,
                    const std::vector<Vec2>   &position,
                    const std::vector<double> &slip) const;
  };
} // namespace hybrid::output
