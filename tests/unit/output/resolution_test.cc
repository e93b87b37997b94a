// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/resolution.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hybrid::output
{
  namespace
  {
    /// Blocks of these sizes [m], the last @p n_bedrock of them bedrock.
    dda::Model blocks(const std::vector<double> &sizes, const int n_bedrock)
    {
      dda::Model model;
      model.blocks.resize(sizes.size());
      for (std::size_t b = 0; b < sizes.size(); ++b)
        model.blocks[b].size = sizes[b];
      model.n_bedrock = n_bedrock;
      return model;
    }


    /// S waves of 1000 m/s in rock, 400 m/s in soil.
    scene::SceneParameters scene()
    {
      scene::SceneParameters scene;
      for (const auto &[name, speed] :
           {std::make_pair("rock", 1000.), std::make_pair("soil", 400.)})
        {
          Material material;
          material.name          = name;
          material.density       = 2000.;
          material.poisson_ratio = 0.25;
          material.young_modulus = 2.5 * material.density * speed * speed;
          scene.materials[name]  = material;
        }
      scene.blocks.material                      = "soil";
      scene.continuum.region_material["bedrock"] = "rock";
      return scene;
    }


    TEST(Resolution, IsThatOfTheLargestBlockAndTheSlowestWave)
    {
      scene::SceneParameters s = scene();
      s.bedrock.carries_waves  = true;
      const dda::Model  model  = blocks({2., 4., 8., 10.}, 2);
      const Resolutions r      = resolve(s, {}, &model, nullptr);
      ASSERT_EQ(r.parts.size(), 2u);
      EXPECT_EQ(name(r.parts[0].part), "the bedrock");
      EXPECT_DOUBLE_EQ(r.parts[0].resolved, 1000. / (10. * 10.));
      EXPECT_EQ(name(r.parts[1].part), "the sliding mass");
      EXPECT_DOUBLE_EQ(r.parts[1].resolved, 400. / (10. * 4.));
      EXPECT_DOUBLE_EQ(r.parts[1].smallest, 2.);
      EXPECT_DOUBLE_EQ(r.lowest(), 10.);
      EXPECT_EQ(r.wanted, 0.); // nothing shakes
    }


    TEST(Resolution, CountsPartsInWhichWavesRun)
    {
      scene::SceneParameters s = scene();
      s.bedrock.carries_waves  = false; // layers
      const dda::Model model   = blocks({4., 50.}, 1);
      EXPECT_DOUBLE_EQ(resolve(s, {}, &model, nullptr).lowest(), 10.);
      const dda::Model layers = blocks({50.}, 1);
      EXPECT_TRUE(std::isnan(resolve(s, {}, &layers, nullptr).lowest()));
      EXPECT_TRUE(std::isnan(resolve(s, {}, nullptr, nullptr).lowest()));
    }


    TEST(Resolution, WetSoilIsSlower)
    {
      scene::SceneParameters s = scene();
      s.materials["wet"]       = s.materials["soil"];
      s.materials["wet"].young_modulus /= 4.;
      s.blocks.saturated_material = "wet";
      const dda::Model model      = blocks({4.}, 0);
      EXPECT_DOUBLE_EQ(resolve(s, {}, &model, nullptr).lowest(), 10.); // no water
      s.environment.water_level = 3.;
      EXPECT_DOUBLE_EQ(resolve(s, {}, &model, nullptr).lowest(), 5.);
    }
  } // namespace
} // namespace hybrid::output
