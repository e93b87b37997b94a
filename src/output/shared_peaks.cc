// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/shared_peaks.h>

namespace hybrid::output
{
  SharedPeaks::SharedPeaks(const continuum::Ownership &of_bedrock, const double corner)
    : ownership(of_bedrock)
    , peaks(corner)
  {}



  void SharedPeaks::pack(const std::vector<double> &whole, std::vector<double> &own) const
  {
    own.clear();
    for (const int unknown : ownership.unknowns())
      own.push_back(whole[unknown]);
  }



  void SharedPeaks::start(const std::vector<double> &velocity)
  {
    pack(velocity, own_velocity);
    peaks.start(own_velocity.data(), own_velocity.size());
  }



  void SharedPeaks::add(const std::vector<double> &displacement,
                        const std::vector<double> &velocity,
                        const double               dt,
                        const double              *base)
  {
    pack(displacement, own_displacement);
    pack(velocity, own_velocity);
    peaks.add(own_displacement.data(), own_velocity.data(), dt, base);
  }



  void SharedPeaks::collect(PeakMotion *of_all)
  {
    constexpr int width = PeakMotion::n_arrays;
    const auto    own   = peaks.arrays();
    packed.clear();
    for (std::size_t i = 0; i < ownership.unknowns().size(); ++i)
      for (const std::vector<double> *array : own)
        packed.push_back((*array)[i]);
    ownership.gather(packed, width, all);
    if (of_all == nullptr)
      return;
    const auto whole = of_all->arrays();
    for (int k = 0; k < width; ++k)
      for (std::size_t i = 0; i < whole[k]->size(); ++i)
        (*whole[k])[i] = all[i * width + k];
  }



  void SharedPeaks::spread(PeakMotion *of_all)
  {
    constexpr int width = PeakMotion::n_arrays;
    if (of_all != nullptr)
      {
        const auto whole = of_all->arrays();
        all.resize(whole[0]->size() * width);
        for (int k = 0; k < width; ++k)
          for (std::size_t i = 0; i < whole[k]->size(); ++i)
            all[i * width + k] = (*whole[k])[i];
      }
    ownership.scatter(all, width, packed);
    const auto own = peaks.arrays();
    for (int k = 0; k < width; ++k)
      {
        own[k]->resize(ownership.unknowns().size());
        for (std::size_t i = 0; i < own[k]->size(); ++i)
          (*own[k])[i] = packed[i * width + k];
      }
  }
} // namespace hybrid::output
