// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/simulation_run.h>

// What the first process records, and the others do for it.
namespace hybrid
{
  bool Simulation::shares_bedrock() const
  {
    return model.continuum != nullptr && model.continuum->ownership() != nullptr;
  }



  output::RunRecorder::Needs Simulation::collect(const output::RunRecorder::Needs &of_first)
  {
    if (model.continuum == nullptr)
      return of_first;
    int asked[2] = {of_first.energy ? 1 : 0, of_first.picture ? 1 : 0};
    if (!is_alone())
      MPI_Bcast(asked, 2, MPI_INT, 0, model.processes);
    model.continuum->collect(state.continuum, asked[0] != 0);
    return {asked[0] != 0, asked[1] != 0};
  }



  void Simulation::tell_of_overlap(output::RunRecorder &recorder) const
  {
    const std::string text = recorder.overlap_warning();
    if (!text.empty())
      log.warning(text);
  }



  void Simulation::start_recording(Run &run)
  {
    collect({true, true});
    if (run.recorder)
      {
        run.recorder->start(state);
        tell_of_overlap(*run.recorder);
      }
    if (run.shared_pictures)
      run.shared_pictures->write(state.continuum, "");
    if (run.shared_peaks)
      run.shared_peaks->start(state.continuum);
  }



  void Simulation::record_step(Run                   &run,
                               const dda::StepResult &result,
                               const double           dt,
                               const double           wall_time)
  {
    const auto needs =
      collect(run.recorder ? run.recorder->needs(state.time, dt) : output::RunRecorder::Needs());
    if (run.recorder)
      {
        run.recorder->record_step(state, result, dt, wall_time);
        tell_of_overlap(*run.recorder);
      }
    if (run.shared_pictures && needs.picture)
      run.shared_pictures->write(state.continuum, "");
    if (!run.shared_peaks)
      return;
    Vec2 base = run.recorder ? run.recorder->base_displacement() : Vec2::Zero();
    MPI_Bcast(base.data(), 2, MPI_DOUBLE, 0, model.processes);
    run.shared_peaks->add(state.continuum, dt, base.data());
  }



  void Simulation::write_shared_peaks(Run &run) const
  {
    if (!run.shared_peaks)
      return;
    if (run.recorder)
      run.recorder->make_room_for_peaks();
    run.shared_peaks->write(directory() + "/run.h5", directory() + "/peaks.vtu");
  }
} // namespace hybrid
