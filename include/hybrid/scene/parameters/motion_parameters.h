// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

namespace hybrid::scene
{
  /// A point source of S waves and the way from it to a rock outcrop, on average over directions.
  struct EarthquakeSource
  {
    double magnitude        = 5.;   ///< moment magnitude [-]
    double distance         = 20e3; ///< from the source to the site [m], > 0
    double stress_drop      = 5e6;  ///< [Pa], > 0
    double velocity         = 3500; ///< of S waves at the source [m/s], > 0
    double density          = 2800; ///< at the source [kg/m3], > 0
    double quality          = 180;  ///< Q at 1 Hz [-], > 0
    double quality_exponent = 0.45; ///< Q = quality f^exponent [-]
    double kappa            = 0.04; ///< attenuation near the site [s], >= 0
  };

  /// Section "Motion".
  struct MotionParameters
  {
    std::string type = "none"; ///< a name of motion_sources()
    std::string file;          ///< for text and at2; resolved path
    double file_unit = 1.; ///< of acceleration in text and spectrum files [m/s2] (parameter "Unit":
                           ///< m/s2 | g | cm/s2 | gal)
    bool   file_unit_is_set = false; ///< by the user
    double peak = -1.; ///< scale to this outcrop/incident peak acceleration [m/s2]; < 0: as it is
    bool   peak_has_unit = false; ///< the user wrote the unit
    std::string
           vertical_file; ///< for text and at2: record along +y beside that of file; resolved path
    double vertical_peak = -1.; ///< scale it to this peak [m/s2]; < 0: by the factor of file
    bool   vertical_peak_has_unit = false; ///< the user wrote the unit
    bool   outcrop =
      true; ///< the motion is the outcrop motion (twice the upgoing wave); false: the upgoing wave
    double angle =
      0.; ///< direction of shaking [deg] from +x: 0 = S wave (horizontal), 90 = P wave (vertical)
    double start               = 0.;  ///< the motion starts at this time [s]
    int    repetitions         = 1;   ///< how often it comes, >= 1
    double repetition_interval = 60.; ///< from one start to the next [s]
    double frequency = 2.;  ///< ricker: dominant; sine: its own; synthetic: predominant [Hz]
    double cycles    = 10.; ///< sine: number of cycles [-], > 0
    /// sine: cycles over which it rises, and falls [-], >= 0; NaN: two, at most half of all
    double           taper             = std::numeric_limits<double>::quiet_NaN();
    double           lowest_frequency  = 0.3; ///< synthetic, stochastic, spectrum: lowest [Hz]
    double           highest_frequency = 8.;  ///< the same: highest [Hz]
    double           duration          = 12.; ///< synthetic and spectrum [s]
    int              seed              = 1;   ///< synthetic, stochastic, spectrum
    EarthquakeSource earthquake;              ///< stochastic
    bool             clough_penzien = false;  ///< synthetic: with the second filter
    std::string      spectrum_file;           ///< spectrum: the target, two columns; resolved path
    bool   spectrum_by_frequency = false; ///< its first column is frequency [Hz]; else period [s]
    double spectrum_damping      = 0.05;  ///< of critical [-], (0, 1)
    bool   baseline_correction =
      true; ///< make velocity and displacement end at zero (all types but ricker, which does)
  };
} // namespace hybrid::scene
