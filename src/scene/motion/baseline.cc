// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/baseline.h>

#include <Eigen/Dense>

#include <cmath>

namespace hybrid::scene
{
  namespace
  {
    /// Velocity of @p motion at its sample @p i [m/s].
    double velocity_at(const Motion &motion, const std::size_t i)
    {
      return motion.velocity(i * motion.time_step());
    }


    /// Take the least-squares polynomial b1 s + b2 s^2 + b3 s^3 (s = t/T) out of the velocity.
    Motion without_velocity_trend(const Motion &motion)
    {
      const std::size_t n      = motion.samples().size();
      const double      T      = motion.duration();
      Eigen::Matrix3d   normal = Eigen::Matrix3d::Zero();
      Eigen::Vector3d   right  = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < n; ++i)
        {
          const double          s = double(i) / (n - 1);
          const Eigen::Vector3d powers(s, s * s, s * s * s);
          normal += powers * powers.transpose();
          right += powers * velocity_at(motion, i);
        }
      const Eigen::Vector3d b = normal.ldlt().solve(right);

      std::vector<double> a = motion.samples();
      for (std::size_t i = 0; i < n; ++i)
        {
          const double s = double(i) / (n - 1);
          a[i] -= (b[0] + s * (2. * b[1] + s * 3. * b[2])) / T;
        }
      return Motion(motion.time_step(), a);
    }


    /// Final velocity [m/s] and displacement over duration [m/s].
    Eigen::Vector2d end_values(const Motion &motion)
    {
      const double T = motion.duration();
      return {motion.velocity(T), motion.displacement(T) / T};
    }


    /// Take two smooth bumps out so that velocity and displacement end at zero.
    Motion ending_at_rest(const Motion &motion)
    {
      const std::size_t   n = motion.samples().size();
      std::vector<double> bump(n), skew(n);
      for (std::size_t i = 0; i < n; ++i)
        {
          const double phase = M_PI * double(i) / (n - 1);
          bump[i]            = std::sin(phase) * std::sin(phase);
          skew[i]            = bump[i] * std::cos(phase);
        }
      Eigen::Matrix2d ends;
      ends.col(0) = end_values(Motion(motion.time_step(), bump));
      ends.col(1) = end_values(Motion(motion.time_step(), skew));

      Motion result = motion;
      for (int pass = 0; pass < 3; ++pass) // the later ones take out the round-off of the earlier
        {
          const Eigen::Vector2d factor = ends.fullPivLu().solve(end_values(result));
          std::vector<double>   a      = result.samples();
          for (std::size_t i = 0; i < n; ++i)
            a[i] -= factor[0] * bump[i] + factor[1] * skew[i];
          result = Motion(motion.time_step(), a);
        }
      return result;
    }
  } // namespace


  Motion baseline_corrected(const Motion &motion, const bool keep_shape)
  {
    if (motion.samples().size() < 4)
      return motion;
    return ending_at_rest(keep_shape ? motion : without_velocity_trend(motion));
  }
} // namespace hybrid::scene
