// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/output/bedding_recorder.h>
#include <hybrid/output/energy_ledger.h>
#include <hybrid/output/history_file.h>
#include <hybrid/output/joint_line_recorder.h>
#include <hybrid/output/line_recorder.h>
#include <hybrid/output/overlap_watch.h>
#include <hybrid/output/peak_fields.h>
#include <hybrid/output/pictures.h>
#include <hybrid/output/probes.h>
#include <hybrid/output/slip_recorder.h>
#include <hybrid/output/step_record.h>
#include <hybrid/output/summary.h>
#include <hybrid/output/watched_points.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/motion/ground_motion.h>
#include <hybrid/scene/motion/spectrum_motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace hybrid::output
{
  class MonitorSummarizer;

  /// The parts of a run that output reads; what a scene does not have is nullptr.
  struct RunParts
  {
    const scene::SceneParameters &scene;
    const scene::SectionMesh     &mesh;
    const scene::GroundMotion    &motion;
    const scene::SpectrumFit     &fit; ///< to a target spectrum; empty: none
    const dda::Model             *blocks;
    const continuum::Continuum   *continuum;
    const coupling::Foundation   *foundation;
  };


  /// Records a run: run.h5, the pictures, and at the end the figures of summary.json.
  class RunRecorder
  {
  public:
    /// Makes run.h5 in the output directory, or goes on with that of an earlier run; serialize()
    /// has to follow then. @throws InputError.
    explicit RunRecorder(const RunParts &parts, HistoryFile::Mode mode = HistoryFile::Mode::create);

    /// The state after the static stage: displacements count from here. Writes the first picture.
    void start(const coupling::CoupledState &state);

    /// After an accepted step of @p dt [s] that took @p wall_time [s].
    void record_step(const coupling::CoupledState &state,
                     const dda::StepResult        &step,
                     double                        dt,
                     double                        wall_time);

    /// The peaks at the bedrock's nodes are SharedPeaks' from now on.
    PeakFields &leave_peaks_of_bedrock()
    {
      peaks.leave_nodes();
      return peaks;
    }

    /// Displacement of the base monitor [m].
    Vec2 base_displacement() const;

    /// What all processes have to do for record_step() at @p time, after a step of @p dt [s].
    struct Needs
    {
      bool energy = false, picture = false;
    };

    Needs needs(double time, double dt) const;

    /// The same for finish().
    Needs needs_at_end(double time) const
    {
      return {last_audit != time, last_picture != time};
    }

    /// After finish(): run.h5 under its temporary name and with places for the bedrock's peaks, for
    /// SharedPeaks; the file itself is that of before. Nothing more is recorded.
    void make_room_for_peaks();

    /// Last picture, joints, section, and what the histories say for the summary.
    void finish(const coupling::CoupledState &state, Summary &summary);

    /// For the difference to a run in other steps. @param until what is later does not count [s]
    StepRecord step_record(double until) const;

    const EnergyLedger &energy() const
    {
      return ledger;
    }

    /// What is to be said of overlaps now, once; empty: nothing.
    std::string overlap_warning()
    {
      return overlaps.warning();
    }

    /// Pictures before the checkpoint whose files are gone, relative to the directory.
    std::vector<std::string> missing_pictures() const
    {
      return pictures.missing_files();
    }

    /// Flush run.h5, safe from a power failure.
    void flush()
    {
      file.flush(true);
    }

    /// For the checkpoint; flush() comes before it. Reading cuts run.h5 and the pictures to what
    /// there was then.
    void serialize(restart::Archive &archive);

  private:
    /// Numbers of the three series of one monitor, and its histories for the summary.
    struct MonitorSeries
    {
      std::string         name;
      int                 probe;
      int                 series[3];
      std::vector<double> histories[3]; ///< displacement, velocity, acceleration; pairs
    };

    struct Profile
    {
      int                 series;
      std::vector<int>    probes;
      std::vector<double> row;
    };

    RunParts          parts;
    Probes            probes;
    HistoryFile       file;
    Pictures          pictures;
    const double      downhill; ///< sign of x downhill; 0: level, or slides that face each other
    BeddingRecorder   bedding;
    SlipRecorder      slip;
    JointLineRecorder joint_lines;
    LineRecorder      lines;
    PeakFields        peaks;
    EnergyLedger      ledger;
    OverlapWatch      overlaps;
    std::vector<MonitorSeries> monitors;
    WatchedPoints              watched;        ///< without monitors, for the error alone
    std::vector<MonitorSeries> watched_motion; ///< of these; no series of run.h5
    std::vector<Profile>       profiles;
    int                        base_monitor = -1; ///< index in monitors
    int time_series = -1, input_series[3] = {-1, -1, -1}, step_series[4] = {-1, -1, -1, -1};
    int energy_time = -1, energy_residual = -1, interface_time = -1, interface_force = -1;
    int interface_sum = -1;
    std::vector<int>    energy_series;
    std::vector<double> times, input_acceleration;
    std::vector<Vec2>   reference_centroids;
    std::vector<double> peak_displacement; ///< of each block relative to the base [m]
    double              next_picture = 0., next_audit = 0.;
    double              last_picture = -1., last_audit = -1.; ///< times; negative: none yet
    std::chrono::steady_clock::time_point last_flush;
    double                                flush_cost = 0.; ///< wall time of the last flush [s]

    /// By how much a record may be early: steps add up with rounding [s].
    static double early_of(const double dt)
    {
      return 1e-9 * dt;
    }

    bool is_audit_due(double time, double dt) const;
    bool is_picture_due(double time, double dt) const;
    void add_monitors();
    void add_watched_points();
    void add_boreholes();
    void add_series();
    void record_motion(const coupling::CoupledState &state);
    void record_energy(const coupling::CoupledState &state);
    void record_picture(const coupling::CoupledState &state);
    void record_total_force(const coupling::CoupledState &state);
    void update_peaks(const coupling::CoupledState &state);
    void read_histories();
    void flush_if_due();
    void write_section(const coupling::CoupledState &state);
    void write_joints(const coupling::CoupledState &state);
    void summarize_monitors(Summary &summary);
    void write_filtered(const MonitorSummarizer &summarizer);
    void estimate_error(Summary &summary) const;

    /// What tells the error: the monitors, or the points that are watched without any.
    const std::vector<MonitorSeries> &points_of_error() const
    {
      return monitors.empty() ? watched_motion : monitors;
    }

    /// Which of them displacements are relative to; -1: none.
    int base_of_error() const;

    /// Why the error of the steps is not estimated, in words; empty: it is.
    std::string why_no_error(bool any_monitor) const;
  };
} // namespace hybrid::output
