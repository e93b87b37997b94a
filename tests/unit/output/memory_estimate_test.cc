// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/output/memory_estimate.h>

#include <gtest/gtest.h>

namespace hybrid::output
{
  namespace
  {
    TEST(MemoryEstimate, CountsHistoriesBySteps)
    {
      scene::SceneParameters scene;
      scene.time.end_time  = 1.;
      scene.time.time_step = 1e-3;
      scene.monitors.monitors.resize(2);
      const double once = estimate_memory(scene, scene::SectionMesh(), nullptr, nullptr).histories;
      scene.time.end_time = 10.;
      const MemoryEstimate estimate =
        estimate_memory(scene, scene::SectionMesh(), nullptr, nullptr);
      EXPECT_NEAR(estimate.histories, 10. * once, 1e-6 * once);
      EXPECT_GT(once, 1000. * 8. * 6. * 2.); // the two monitors alone
      EXPECT_GT(estimate.built, 1e6);        // this process
      EXPECT_EQ(estimate.continuum + estimate.blocks, 0.);
    }



    TEST(MemoryEstimate, WarnsBeyondWhatThereIs)
    {
      MemoryEstimate estimate;
      estimate.built     = 100. * 1048576.;
      estimate.continuum = 50. * 1048576.;
      EXPECT_EQ(memory_warning(estimate, 1, 151. * 1048576.), "");
      const std::string text = memory_warning(estimate, 1, 149. * 1048576.);
      EXPECT_NE(text.find("needs about 150 MB"), std::string::npos) << text;
      EXPECT_NE(text.find("has 149 MB"), std::string::npos) << text;
      EXPECT_NE(describe(estimate, 1).find("about 150 MB"), std::string::npos);
      EXPECT_EQ(describe(estimate, 1).find("slide"), std::string::npos);
      estimate.sliding = 20. * 1048576.;
      EXPECT_NE(describe(estimate, 1).find("about 150 MB"), std::string::npos);
      EXPECT_NE(describe(estimate, 1).find("once joints slide 20 more"), std::string::npos);
      EXPECT_NE(memory_warning(estimate, 1, 169. * 1048576.).find("needs about 170 MB"),
                std::string::npos);
      estimate.preparation = 300. * 1048576.;
      EXPECT_NE(describe(estimate, 1).find("about 300 MB"), std::string::npos);
      EXPECT_GT(available_memory(), 1e7);
    }



    TEST(MemoryEstimate, CountsAllProcessesOfAMachine)
    {
      MemoryEstimate estimate;
      estimate.built = 100. * 1048576.;
      EXPECT_EQ(describe(estimate, 1).find("each process"), std::string::npos);
      EXPECT_NE(describe(estimate, 4).find("about 100 MB for each process:"), std::string::npos);
      EXPECT_EQ(memory_warning(estimate, 4, 401. * 1048576.), "");
      const std::string text = memory_warning(estimate, 4, 399. * 1048576.);
      EXPECT_NE(text.find("the 4 processes on this machine need about 400 MB"), std::string::npos)
        << text;
      EXPECT_NE(text.find("fewer processes"), std::string::npos) << text;
    }
  } // namespace
} // namespace hybrid::output
