// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/output/response_delay.h>
#include <hybrid/output/step_frequency.h>
#include <hybrid/output/summary.h>

#include <functional>
#include <string>
#include <vector>

namespace hybrid::output
{
  /// What the error of a run is estimated from: what its monitors recorded.
  struct ErrorRecord
  {
    /// A point that moves with the rock or with a block that joints hold.
    struct Monitor
    {
      std::string                name;
      const std::vector<double> *displacement;   ///< absolute, pairs, one per time [m]
      bool                       in_rock = true; ///< in finite elements
      /// On a base that has the accelerations of the motion at the end of each step, which have no
      /// error.
      bool is_led = false;
    };

    std::vector<double>  time; ///< end of each step [s]
    std::vector<Monitor> monitors;
    int                  base = -1;    ///< monitor that displacements are relative to; -1: absolute
    bool base_is_prescribed   = false; ///< what stands on it has velocities and accelerations by
                                       ///< the scheme from displacements that the base has exactly

    /// Displacement of what shakes the model at a time [s], beyond the end as well, any unit;
    /// empty: it is set off at t = 0.
    std::function<double(double)> source;

    double least_motion = 1e-3; ///< of the largest: monitors that move less are left out [-]
    double corner       = 25.;  ///< of the zero-phase low-pass before peaks [Hz]; 0: none
    double until = MonitorSummary::unknown; ///< what is later is left out [s]; NaN: nothing is
  };


  /// An error in frequency, s' - s at s [1/s].
  using FrequencyError = std::function<std::complex<double>(std::complex<double> s)>;


  /**
   * The probable error of a run's waves from what its monitors recorded (ResponseDelay).
   *
   * Velocities are means over rows, as far apart as an eighth of the period of the corner, at
   * least a step. The error of the displacement relative to the base and that of the acceleration
   * are the integral and the derivative of that of the velocity. All pass the low-pass that peaks
   * are taken after.
   */
  class ProbableError
  {
  public:
    /// There are at least two times.
    explicit ProbableError(const ErrorRecord &record);

    /// Largest error at any time over the peak of the same monitor, of those in finite elements.
    /// Monitors that move less than the record's least_motion are left out, and so are
    /// accelerations of those that are led.
    /// @param highest angular frequency that is asked about [1/s]; errors fade above half of it.
    Summary::ErrorPart in_rock(const FrequencyError &error, double highest) const;

    /// The same of the steps, of all monitors. Scheme and late damping have different signs: at
    /// least three tenths of the sum of both count.
    Summary::ErrorPart of_steps(const StepScheme &scheme) const;

    /// A monitor whose motion has hardly begun when the record ends: more than nine tenths of the
    /// sum of v^2 are in the last fifth of it. All that is known of its answer then is how a first
    /// wave grows, and its error is told wrong by any factor. Empty: there is none.
    std::string hardly_begun() const;

    /// A monitor that a wave reaches as the record ends: of its peak velocity a twentieth or more
    /// is no answer that the record tells of, in its last tenth. Empty: there is none.
    std::string reached_at_end() const;

  private:
    using History = std::vector<double>;

    struct Motion
    {
      std::string          name;
      bool                 in_rock, is_led;
      History              velocity[2];
      History              relative[2]; ///< displacement less that of the base, filtered
      ResponseDelay::Delay delay[2];
      double               peak[3] = {0., 0., 0.}; ///< of vectors, see Summary::ErrorPart
    };

    std::vector<double> time; ///< of the record, as far as it is looked at [s]
    double              corner, least_motion, spacing = 0.;
    std::size_t         rows = 0, rows_until = 0;
    int                 base;
    bool                base_is_prescribed;
    std::vector<Motion> motions;
    double              largest[3] = {0., 0., 0.};
    ResponseDelay       response;

    static double make_spacing(const std::vector<double> &time, double corner);
    bool          counts(std::size_t motion, int quantity) const;
    History       filtered(const History &history) const;
    double        largest_size(const History &x, const History &y) const;
    void          add(const ErrorRecord::Monitor &monitor);
    void          find_peaks();
    void          find_delays();
    std::array<History, 3>
         changes(const Motion &motion, int c, const ResponseDelay::Spectrum &frequency) const;
    void add_amplitude(const Motion &motion, int c, double dt, std::array<History, 3> &error) const;

    /// Whether a base that moves as prescribed leads a monitor by an implicit scheme.
    bool leads(const Motion &motion, const StepScheme &scheme) const
    {
      return base_is_prescribed && !motion.is_led && scheme.newmark.corrected_step == 0. &&
             scheme.newmark.beta > 0.;
    }

    /// Of what a base leads: v = (2 x / dt) u and a = s'^2 u (StepScheme) in place of s u and s^2
    /// u, to second order. Makes the error of the acceleration.
    void add_rates(const Motion           &motion,
                   int                     c,
                   const StepScheme       &scheme,
                   std::array<History, 3> &error) const;

    /// @param amplitudes of this scheme count, too; nullptr: none do
    Summary::ErrorPart evaluate(const FrequencyError &error,
                                double                highest,
                                const StepScheme     *amplitudes,
                                bool                  only_rock) const;
  };
} // namespace hybrid::output
