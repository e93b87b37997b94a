// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/resolution.h>

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

namespace hybrid::output
{
  namespace
  {
    constexpr double points_per_wavelength = 10.;



    /// Means of as many samples that at most 131,072 are left.
    scene::Motion averaged(const scene::Motion &motion)
    {
      const auto       &a     = motion.samples();
      const std::size_t most  = std::size_t{1} << 17;
      const std::size_t group = (a.size() + most - 1) / most;
      if (group < 2)
        return motion;
      std::vector<double> means(a.size() / group);
      for (std::size_t i = 0; i < means.size(); ++i)
        means[i] =
          std::accumulate(a.begin() + i * group, a.begin() + (i + 1) * group, 0.) / double(group);
      return {group * motion.time_step(), means};
    }



    /// Below which 95 % of the energy of point loads and initial wave are [Hz]. The power of a
    /// Ricker wavelet is that of a chi-square distribution of 4 (f / f_0)^2 with five degrees of
    /// freedom; that of a packet, l wave lengths long, is normal with deviation f_0 / (sqrt(8) pi
    /// l).
    double highest_frequency(const scene::SceneParameters &scene)
    {
      double result = 0.;
      if (!scene.has_continuum())
        return result;
      if (!scene.point_loads.loads.empty())
        result = 1.664 * scene.point_loads.frequency;
      const scene::InitialWaveParameters &wave = scene.initial_wave;
      if (wave.type != scene::WaveType::none)
        result =
          std::max(result, wave.frequency * (1. + 1.645 / (std::sqrt(8.) * M_PI * wave.length)));
      return result;
    }



    Resolution of_continuum(const continuum::Continuum &continuum, const int degree)
    {
      const auto r = continuum.resolution();
      return {ModelPart::continuum,
              r.highest_frequency,
              r.slowest_s_wave,
              0.,
              0.,
              points_per_wavelength / degree};
    }



    Resolution
    of_blocks(const ModelPart part, const double slowest, const std::pair<double, double> &size)
    {
      const double resolved = slowest / (points_per_wavelength * size.second);
      return {part, resolved, slowest, size.first, size.second, points_per_wavelength};
    }



    double slowest_wave_of_bedrock(const scene::SceneParameters &scene)
    {
      double slowest = 1e300;
      for (const std::string &name : scene.continuum.region_material.names())
        slowest = std::min(slowest, scene.material(name, "Continuum/Materials").s_wave_speed());
      return slowest;
    }



    double slowest_wave_of_mass(const scene::SceneParameters &scene)
    {
      double slowest = 1e300;
      for (const std::string &name : scene.mass_materials())
        slowest = std::min(slowest, scene.material(name, "Blocks/Material").s_wave_speed());
      return slowest;
    }
  } // namespace



  std::string name(const ModelPart part)
  {
    const char *names[] = {"the continuum", "the bedrock", "the sliding mass"};
    return names[static_cast<int>(part)];
  }



  double Resolutions::lowest() const
  {
    double result = std::numeric_limits<double>::quiet_NaN();
    for (const Resolution &part : parts)
      result = std::fmin(result, part.resolved);
    return result;
  }



  std::pair<double, double> block_sizes(const dda::Model &model, const int begin, const int end)
  {
    double smallest = 1e300, largest = 0.;
    for (int b = begin; b < end; ++b)
      {
        smallest = std::min(smallest, model.blocks[b].size);
        largest  = std::max(largest, model.blocks[b].size);
      }
    return {smallest, largest};
  }



  double highest_frequency(const scene::Motion &motion, const double share)
  {
    const scene::Motion coarse = averaged(motion);
    std::vector<double> a      = coarse.samples();
    if (a.size() < 2)
      return 0.;
    std::size_t n = 4096; // frequencies near each other
    while (n < 2 * a.size())
      n *= 2;
    a.resize(n, 0.);
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double>                transform;
    transform.fwd(spectrum, a);
    double total = 0., below = 0.;
    for (std::size_t k = 1; k <= n / 2; ++k)
      total += std::norm(spectrum[k]);
    for (std::size_t k = 1; k <= n / 2 && total > 0.; ++k)
      if ((below += std::norm(spectrum[k])) >= share * total)
        return k / (n * coarse.time_step());
    return 0.;
  }



  Resolutions resolve(const scene::SceneParameters &scene,
                      const scene::Motion          &motion,
                      const dda::Model             *blocks,
                      const continuum::Continuum   *continuum)
  {
    Resolutions result;
    result.wanted =
      std::max(motion.empty() ? 0. : highest_frequency(motion), highest_frequency(scene));
    if (continuum != nullptr)
      result.parts.push_back(of_continuum(*continuum, scene.continuum.degree));
    if (blocks == nullptr)
      return result;
    const int n_mass = blocks->n_mass();
    if (blocks->n_bedrock > 0 && scene.bedrock.carries_waves)
      result.parts.push_back(of_blocks(ModelPart::bedrock,
                                       slowest_wave_of_bedrock(scene),
                                       block_sizes(*blocks, n_mass, blocks->n_blocks())));
    if (n_mass > 0)
      result.parts.push_back(
        of_blocks(ModelPart::mass, slowest_wave_of_mass(scene), block_sizes(*blocks, 0, n_mass)));
    return result;
  }
} // namespace hybrid::output
